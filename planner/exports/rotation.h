// Rotations as the exported files write them.
#pragma once

#include "sim/base/pose.h"

namespace prehend {

// The unit quaternion of a pose with w >= 0: one of the two that mean the same.
inline Eigen::Quaterniond unit_quaternion(const Pose& pose) {
  Eigen::Quaterniond q(pose.linear());
  q.normalize();
  if (q.w() < 0.0) q.coeffs() *= -1.0;
  return q;
}

}  // namespace prehend
