// Rotations as all files write them.
#pragma once

#include "sim/base/pose.h"

namespace prehend {

// Of the two quaternions that mean a pose's rotation the one with w >= 0. Its length is 1 up to
// rounding; writers whose readers insist on 1 normalise it.
inline Eigen::Quaterniond quaternion_of(const Pose& pose) {
  Eigen::Quaterniond q(pose.linear());
  if (q.w() < 0.0) q.coeffs() *= -1.0;
  return q;
}

}  // namespace prehend
