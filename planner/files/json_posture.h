// Numbers in a grasp file that say where a robot stands: its degrees of freedom or its joints, in
// the order of the robot's file [rad or m].
#pragma once

#include <vector>

#include "sim/json/json_field.h"
#include "sim/robot/robot.h"

namespace prehend {

// Values outside the limits by more than this are refused; by less, they are rounding [rad or m].
inline constexpr double kLimitTolerance = 1e-6;

// A number a degree of freedom, brought inside the limits where rounding left them. Throws
// InputError for another count, or a value that is farther outside.
std::vector<double> read_dofs(const JsonField& field, const Robot& robot);

// A number a joint, as they stand in the file. Throws InputError as read_dofs.
std::vector<double> read_joints(const JsonField& field, const Robot& robot);

// Throws InputError that names the number which is outside its joint's limits.
void check_joint_limits(const JsonField& field, const Robot& robot);

}  // namespace prehend
