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
  bool abducts = false;          // a joint before them swings it to both sides
};

// How a joint is written: with the opposite axis, with its frame turned, and with the value that it
// has at the start.
struct Writing {
  bool flipped = false;
  Matrix3 R = Matrix3::Identity();
  double start = 0.0;  // [rad or m]
};

// A palm in the plane y z with two to four fingers at its upper edge, which bend towards x, and a
// thumb that stands out of it and bends towards them.
std::vector<MadeFinger> random_fingers(Random& random);

std::size_t joint_count(const std::vector<MadeFinger>& fingers);

// One writing per joint, finger by finger.
Robot made_hand(const std::vector<MadeFinger>& fingers, const std::vector<Writing>& writings);

// A jaw that slides along x towards one that stands on the palm, and what it leaves open [m]. One
// writing.
Robot made_fixed_jaw(double opening, const Writing& writing);

// The hand turned and moved as a whole.
Robot turned_hand(Robot robot, const Pose& X);

// Joints written in any of the ways that mean the same.
std::vector<Writing> random_writings(Random& random, std::size_t joints);

// The same with zeros that are anywhere: each joint has another value at the start.
std::vector<Writing> with_random_starts(Random& random, std::vector<Writing> writings);

}  // namespace prehend
