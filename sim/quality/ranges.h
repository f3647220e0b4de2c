// The ranges of numbers that the quality measures accept. They cover whatever can be gripped with a
// wide margin, and all that is computed from them fits doubles: the largest coordinate of a wrench
// is below 1e22, and its sixth power, a volume, below 1e132.
#pragma once

#include "sim/base/range.h"

namespace prehend {

// Of WrenchFrame::torque_scale [1/m].
inline constexpr double kSmallestTorqueScale = 1e-9;
inline constexpr double kLargestTorqueScale = 1e9;

// Weights, joint torque limits and lengths of directions that are not zero are at least this.
inline constexpr double kSmallestLoad = 1e-9;
// The smallest length of a wrench of a task that is not zero, with its torque scaled: that of a
// torque of kSmallestLoad at the smallest torque scale.
inline constexpr double kSmallestTask = kSmallestLoad * kSmallestTorqueScale;

// Entries of a hand's Jacobian and spin matrix, in magnitude [m/s per rad/s, rad/s per rad/s].
inline constexpr double kLargestJacobian = 1e6;

// Edges of a friction pyramid. With the most, epsilon is within 5e-6 of that of the exact cone.
inline constexpr int kFewestEdges = static_cast<int>(kConeEdges.lower);
inline constexpr int kMostEdges = static_cast<int>(kConeEdges.upper);

}  // namespace prehend
