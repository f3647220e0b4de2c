// Reads URDF, the Unified Robot Description Format of ROS (docs/reference/urdf-files.md).
#pragma once

#include "sim/base/xml/xml_file.h"
#include "sim/robot/files/joint_tree.h"
#include "sim/robot/files/package_folders.h"

namespace prehend {

// The links and joints of a file whose outermost element is <robot>. Continuous joints get limits
// of two turns in all. What is not used is in the notes. Throws InputError "FILE: line 12, <joint>:
// problem (VALUE)": a missing mesh, an unknown shape or joint type, a joint that names missing
// links, floating and planar joints, limits the wrong way round.
// Source: http://wiki.ros.org/urdf/XML
JointTree read_urdf(const XmlFile& file, const ForeignRobotOptions& options = {});

}  // namespace prehend
