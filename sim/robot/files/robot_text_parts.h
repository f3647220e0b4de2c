// Parts of a robot file that files beside other formats have as well.
#pragma once

#include <nlohmann/json.hpp>

#include "sim/robot/robot.h"

namespace prehend {

// The fields of a degree of freedom beside its name and what it drives, in SI units.
nlohmann::ordered_json motion_json(const DegreeOfFreedom& dof);

// The field "spring" of a joint that has one, in SI units.
nlohmann::ordered_json spring_json(const JointSpring& spring);

// The field "hand" of a robot that has one, in SI units.
nlohmann::ordered_json hand_json(const Robot& robot);

}  // namespace prehend
