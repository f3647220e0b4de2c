// Rotations as unit quaternions, in the form in which all files state them.
#pragma once

#include "sim/base/pose.h"

namespace prehend {

// The rotation of `pose` as a quaternion. Two quaternions, q and -q, stand for one rotation; this
// is the one with w >= 0. Its length is 1 up to rounding; writers of formats that need exact unit
// length normalise it.
inline Eigen::Quaterniond quaternion_of(const Pose& pose) {
  Eigen::Quaterniond q(pose.linear());
  if (q.w() < 0.0) q.coeffs() *= -1.0;
  return q;
}

}  // namespace prehend
