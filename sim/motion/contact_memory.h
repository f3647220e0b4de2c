// Contacts between the bodies and links of a world, kept from step to step while nothing has moved
// far enough to change them.
#pragma once

#include <limits>
#include <vector>

#include <Eigen/Core>

#include "sim/base/pose.h"
#include "sim/shape/proximity.h"

namespace prehend {

// A body of a world (robot -1), or a link of one of its robots.
struct SolidId {
  int robot = -1;
  int index = 0;
  friend bool operator==(const SolidId&, const SolidId&) = default;
  friend auto operator<=>(const SolidId&, const SolidId&) = default;
};

// A contact fixed to both of its solids, so that its gap follows their motion: the point on each,
// and the normal in the frame of the first.
struct HeldContact {
  Vector3 p_A = Vector3::Zero();
  Vector3 p_B = Vector3::Zero();
  Vector3 normal_A = Vector3::UnitZ();                // unit, from b into a
  Eigen::Vector4d impulse = Eigen::Vector4d::Zero();  // of the last step, over its time [N]
  bool slides =
      false;  // in the last step; else it sticks where p_A and p_B were opposite each other
  // Where the search for the next impulse begins: at that of the last step, or of an earlier try
  // of this one, over its time [N].
  Eigen::Vector4d guess = Eigen::Vector4d::Zero();
};

// What is known of a pair of solids since it was last looked at.
struct PairMemory {
  SolidId a = {};
  SolidId b = {};
  Pose X_AB = Pose::Identity();  // when it was looked at
  double at_least = 0.0;  // the gap was at least this [m]; where contacts are held, of all others
  std::vector<HeldContact> contacts = {};
  TrianglePair nearest = {};  // the closest that was found last
  double gap = 0.0;           // where contacts are held: that of the surfaces was at least this [m]
  // The surfaces cross by a little: contacts cannot be found, and those held push them apart.
  bool crosses = false;
  // WarmStart::stiffness of the last step.
  double stiffness = std::numeric_limits<double>::infinity();
};

// In ascending order of the pairs.
struct ContactMemory {
  std::vector<PairMemory> pairs;
};

}  // namespace prehend
