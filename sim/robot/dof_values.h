// A posture of a robot.
#pragma once

#include <vector>

namespace prehend {

// A value for every degree of freedom of a robot, in the order of Robot::dofs [rad or m].
using DofValues = std::vector<double>;

}  // namespace prehend
