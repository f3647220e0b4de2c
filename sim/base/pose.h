// Vectors and poses. X_AB is the pose of frame B in frame A: p_A = X_AB * p_B.
#pragma once

#include <Eigen/Geometry>

#include "sim/base/eigen_alignment.h"

namespace prehend {

using Vector3 = Eigen::Vector3d;
using Matrix3 = Eigen::Matrix3d;
// A rigid transform: rotation and translation [m].
using Pose = Eigen::Isometry3d;

// Pose without rotation, at p [m].
inline Pose translation(const Vector3& p) { return Pose(Eigen::Translation3d(p)); }

// Pose with the rotation whose columns are the given axes (right-handed, orthonormal).
inline Pose pose_from(const Matrix3& rotation, const Vector3& p) {
  Pose pose = Pose::Identity();
  pose.linear() = rotation;
  pose.translation() = p;
  return pose;
}

// Whether it moves nothing, to the last bit.
inline bool is_identity(const Pose& pose) {
  return pose.linear() == Matrix3::Identity() && pose.translation() == Vector3::Zero();
}

// A unit vector orthogonal to `v`, which must not be zero. Equal arguments give equal results, so
// that runs repeat.
inline Vector3 any_orthogonal(const Vector3& v) { return v.unitOrthogonal(); }

// The rotation of `pose` as a unit quaternion, the form in which all files state rotations. Two
// quaternions, q and -q, stand for one rotation; this is the one with w >= 0. Its length is 1 up to
// rounding; writers of formats that need exact unit length normalise it.
inline Eigen::Quaterniond quaternion_of(const Pose& pose) {
  Eigen::Quaterniond q(pose.linear());
  if (q.w() < 0.0) q.coeffs() *= -1.0;
  return q;
}

}  // namespace prehend
