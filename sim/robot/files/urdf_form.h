// Robots as URDF can say them.
#pragma once

#include <string>

#include "sim/robot/robot.h"

namespace prehend {

// The same robot with `prefix` before all its names, and every degree of freedom called after one
// of its joints, whose value it is (ratio 1, offset 0): one that is so already, else the first.
Robot urdf_form(Robot robot, const std::string& prefix);

}  // namespace prehend
