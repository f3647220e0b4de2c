// How fast joints may move.
#pragma once

#include <vector>

namespace prehend {

// One number a joint, finite and > 0 for every joint that moves; those of others are not looked at.
struct JointLimits {
  std::vector<double> velocity;      // rad/s or m/s
  std::vector<double> acceleration;  // rad/s^2 or m/s^2
};

}  // namespace prehend
