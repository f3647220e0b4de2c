// MJCF files that are made of parts: other files, frames and repeated elements.
// Source: https://mujoco.readthedocs.io/en/stable/XMLreference.html
#pragma once

#include "sim/base/xml/xml_file.h"

namespace prehend {

// Whether there is any of what whole_mjcf resolves.
bool has_mjcf_parts(const XmlFile& file);

// The same robot without <include>, <frame> and <replicate>: what they hold stands in their place,
// at its pose in the body around them; names of repeated elements end with their number. Elements
// keep the place where they were written. Throws InputError that names it: a file that is not
// there, files that include each other, a pose that cannot be read, joints in a frame, and a robot
// that grows to more than XmlMaker takes.
XmlFile whole_mjcf(const XmlFile& file);

}  // namespace prehend
