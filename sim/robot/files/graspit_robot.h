// Robots in GraspIt!'s own files (docs/reference/graspit-files.md).
#pragma once

#include "sim/base/xml/xml_file.h"
#include "sim/robot/robot.h"

namespace prehend {

// Whether the root element is that of a GraspIt! robot: <robot> with a <palm>. Those of URDF have
// none.
bool is_graspit_robot(const XmlFile& file);

// The robot in such a file; its links are body files (graspit_body.h) in the folder iv beside it.
// Degrees of freedom are called d0, d1, ..., joints chain0_joint0, ..., and links chain0_link0,
// ..., as they are numbered there. Robot::hand has the direction of approach and its origin where
// the file states them, without preshapes and closing axis.
//
// Throws InputError "FILE: line 12, <theta>: problem (VALUE)" for what is broken or missing, a
// joint that no degree of freedom drives or one that is not there, a degree of freedom without a
// joint, with joints of two types or without a value inside all their limits, and links that need
// another number of joints than there are.
Robot read_graspit_robot(const XmlFile& file);

// The body file of a link: in the folder iv beside the robot's file, else beside it.
std::filesystem::path graspit_link_file(const XmlElement& link);

}  // namespace prehend
