// Angles and rotations as tests write them.
#pragma once

#include <numbers>

#include "sim/base/pose.h"

namespace prehend::test {

inline constexpr double kDegree = std::numbers::pi / 180.0;  // rad

// A rotation about a unit axis through the origin.
inline Pose turned(double angle, const Vector3& axis) {
  return Pose(Eigen::AngleAxisd(angle, axis));
}

}  // namespace prehend::test
