// Models in SDF, the format of Gazebo, from version 1.4 on. Source: http://sdformat.org/spec
#pragma once

#include "sim/base/xml/xml_file.h"
#include "sim/robot/files/package_folders.h"

namespace prehend {

// The robot of the file (sdf_parts.h) as URDF says it: links, joints that turn, slide or hold, with
// limits, friction and mimics, poses relative to any frame, shapes and masses. A joint to a link
// that another joint carries becomes a <loop_joint>. Elements keep the place where they were
// written. Throws InputError that names it: other joints and shapes, frames that are not there or
// relative to each other, and what whole_sdf refuses.
XmlFile urdf_of_sdf(const XmlFile& file, const PackageFolders& packages = {});

}  // namespace prehend
