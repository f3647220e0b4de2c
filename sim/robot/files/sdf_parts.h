// SDF models that are put together from others.
#pragma once

#include "sim/base/xml/xml_file.h"
#include "sim/robot/files/package_folders.h"

namespace prehend {

// The robot of the file as one model: what stands in models inside it, or in models that it
// includes, is called MODEL::NAME, as in the format, with places and axes relative to the frame
// MODEL. Of several models beside each other, in a world too, the robot is the one whose joints
// move. Included models are looked for as resolved_uri says, a folder by its model.config or
// model.sdf; one beside the robot that is not found is left out. Throws InputError that names the
// place: no model, several robots (the message lists them), models that include themselves,
// placement frames.
XmlFile whole_sdf(const XmlFile& file, const PackageFolders& packages);

}  // namespace prehend
