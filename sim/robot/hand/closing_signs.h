// Towards which of its limits each degree of freedom closes a hand, found by closing it both ways.
#pragma once

#include <vector>

#include "sim/robot/hand/closing_dofs.h"

namespace prehend {

// 1, -1 or 0 (does not close) per degree of freedom.
//
// The joints that bend one finger turn in the same sense. Fingers that are built alike (as many
// bending joints, with the same ranges or with mirrored ones) bend alike where their ranges say
// which way is which. All ways that are left are tried together; the best is that with which a
// thumb and the other fingers come nearest to each other, of fingers with several bending joints
// also that which bends them over the larger part of their ranges. Then each joint, with those of
// the fingers that are built alike, is turned around where that is much better: fingers whose last
// links stay parallel. Frames of links and joints have no say in it.
std::vector<int> find_closing_signs(const Robot& robot, const HandParts& parts);

}  // namespace prehend
