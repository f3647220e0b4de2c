// Reads a joint of a robot file (docs/robot-file.md, "Chains and joints").
#pragma once

#include "sim/json/json_field.h"
#include "sim/robot/robot.h"
#include "sim/robot/robot_geometry.h"

namespace prehend {

// A joint written with theta, d, a, alpha or with an origin and an axis; limits, effort, friction.
// X_PJ is the pose in the frame in which the file gives the joint. What drives the joint, its
// parent and its chain are left as they are. Throws InputError that names the field.
Joint read_joint(const JsonField& field, const FileUnits& units);

}  // namespace prehend
