// The part of a robot file that makes the robot a hand.
#pragma once

#include "sim/json/json_field.h"
#include "sim/robot/robot.h"
#include "sim/robot/robot_geometry.h"

namespace prehend {

// The hand of a robot whose joints and degrees of freedom have been read already. Throws InputError
// that names the field.
Hand read_hand(const JsonField& field, const FileUnits& units, const Robot& robot);

// The factor from the file's unit to SI for values of a degree of freedom: of angles or of lengths,
// depending on its joints.
double value_unit(const Robot& robot, std::size_t dof, const FileUnits& units);

}  // namespace prehend
