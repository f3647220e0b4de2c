// The part of a robot file that makes the robot a hand.
#pragma once

#include "sim/json/json_field.h"
#include "sim/robot/robot.h"
#include "sim/robot/robot_geometry.h"

namespace prehend {

// `robot` has its joints and degrees of freedom already.
Hand read_hand(const JsonField& field, const FileUnits& units, const Robot& robot);

// What one unit of a degree of freedom's value is worth in SI: angle or length, like its joints.
double value_unit(const Robot& robot, std::size_t dof, const FileUnits& units);

}  // namespace prehend
