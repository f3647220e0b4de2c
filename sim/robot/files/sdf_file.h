// Models in SDF, the format of Gazebo, from version 1.4 on. Source: http://sdformat.org/spec
#pragma once

#include "sim/base/xml/xml_file.h"

namespace prehend {

// The only model of the file as URDF says it: links, joints that turn, slide or hold, with limits,
// friction and mimics, poses relative to any frame, shapes and masses. Elements keep the place
// where they were written. Throws InputError that names it: models in models, included models,
// other joints and shapes, frames that are not there or relative to each other.
XmlFile urdf_of_sdf(const XmlFile& file);

}  // namespace prehend
