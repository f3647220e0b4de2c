// Hands made of boxes, for the tests of what is derived of hands.
#pragma once

#include <string>
#include <vector>

#include "sim/base/random.h"
#include "sim/robot/robot.h"

namespace prehend {

inline constexpr int kPhalanges = 3;

// Where a finger begins, towards what it bends, and its sizes.
struct MadeFinger {
  std::string name;
  Pose X_BF = Pose::Identity();  // z along the finger, bends about y towards x
  std::vector<double> lengths;   // of its phalanges [m]
};

// How a joint is written: with the opposite axis, and with its frame turned.
struct Writing {
  bool flipped = false;
  Matrix3 R = Matrix3::Identity();
};

// A palm in the plane y z with two to four fingers at its upper edge, which bend towards x, and a
// thumb that stands out of it and bends towards them.
std::vector<MadeFinger> random_fingers(Random& random);

// One writing per joint, finger by finger.
Robot made_hand(const std::vector<MadeFinger>& fingers, const std::vector<Writing>& writings);

// Joints written in any of the ways that mean the same.
std::vector<Writing> random_writings(Random& random, std::size_t joints);

}  // namespace prehend
