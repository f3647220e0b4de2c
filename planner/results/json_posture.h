// Readers of a robot's posture in a grasp file: values of its degrees of freedom or of its joints,
// in the order of the robot's file [rad or m].
#pragma once

#include <vector>

#include "sim/base/json/json_field.h"
#include "sim/robot/robot.h"

namespace prehend {

// Values outside the limits by more than this are refused; smaller excess is taken for rounding
// [rad or m].
inline constexpr double kLimitTolerance = 1e-6;

// One value for each degree of freedom, clamped to the limits where rounding left them. Throws
// InputError for another count, or a value that is farther outside.
std::vector<double> read_dofs(const JsonField& field, const Robot& robot);

// One value for each joint, unchanged. Throws InputError as read_dofs.
std::vector<double> read_joints(const JsonField& field, const Robot& robot);

// Throws InputError that names the number which is outside its joint's limits.
void check_joint_limits(const JsonField& field, const Robot& robot);

}  // namespace prehend
