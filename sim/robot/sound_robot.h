// What every robot is, wherever it comes from.
#pragma once

#include <string>

#include "sim/base/range.h"
#include "sim/robot/robot.h"

namespace prehend {

// The size of the ratio of a joint's value to that of its degree of freedom: limits are divided by
// it.
inline constexpr Range kRatioSize{.lower = 1e-9, .upper = 1e9};

// Throws InputError "ROBOT: joint NAME: ..." unless every joint stands after its parent, has a unit
// axis and a degree of freedom, every chain is a path, exempt pairs are of links, there are at most
// 1000 joints, and all numbers are within the limits of their kind (range.h). Robots read from
// files are like this; those built in code are checked when they are compiled or assembled.
void require_sound(const Robot& robot);
// The same; messages name `place`, the robot's file.
void require_sound(const Robot& robot, const std::string& place);

}  // namespace prehend
