// Which pairs of a robot's links may collide with each other.
#pragma once

#include <utility>
#include <vector>

#include "sim/robot/robot.h"

namespace prehend {

// All pairs of links (indices, the lower one first) that are checked for self-collision. Left out
// are two links on the same joint, which never move against each other, and two of which one
// carries the other with no third link between them, whose meshes overlap there by construction:
// neighbours in a chain, and a chain's first link with the link that carries it; also the pairs
// that the robot exempts.
std::vector<std::pair<int, int>> checked_pairs(const Robot& robot);

}  // namespace prehend
