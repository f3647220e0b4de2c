// The parts of a robot file that robot_file.h and platform_file.h put together
// (docs/reference/robot-file.md). Each throws InputError that names the field.
#pragma once

#include "sim/base/json/json_field.h"
#include "sim/robot/files/robot_geometry.h"
#include "sim/robot/robot.h"

namespace prehend {

// A joint written with theta, d, a, alpha or with an origin and an axis; limits, effort, friction,
// spring. X_PJ is the pose in the frame in which the file gives the joint. What drives the joint,
// its parent and its chain are left as they are.
Joint read_joint(const JsonField& field, const FileUnits& units);

// The spring of a joint of that type.
JointSpring read_spring(const JsonField& field, JointType type, const FileUnits& units);

// Name, material, geometry and mass of a link that follows `joint` (-1: the base). Which fields
// there may be is the caller's to check. Refused are an unknown material, a geometry without a
// solid whose mass is to be found from it, and an inertia that no body has.
Link read_link(const JsonField& field, const FileUnits& units, const NamedGeometry& named,
               ShapeBudget& budget, int joint);

// The hand of a robot whose joints and degrees of freedom have been read already.
Hand read_hand(const JsonField& field, const FileUnits& units, const Robot& robot);

// Initial value, closing velocity, largest velocity and acceleration, coupling and gains of a
// degree of freedom of `robot`, whose joints and limits have been read already. What the field does
// not say stays as it is.
void read_motion(const JsonField& field, const FileUnits& units, int dof, Robot& robot);

// The factor from the file's unit to SI for values of a degree of freedom: of angles or of lengths,
// depending on its joints.
double value_unit(const Robot& robot, std::size_t dof, const FileUnits& units);

}  // namespace prehend
