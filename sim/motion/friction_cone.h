// The friction cone {(p_n, p_t) : |p_t| <= mu p_n} and the nearest point in it.
#pragma once

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

namespace prehend {

// The normal, two tangents and torsion. What a condition does not have is 0.
using ConeVector = Eigen::Vector4d;
using ConeMatrix = Eigen::Matrix4d;

// The nearest point of the cone, and how it changes with x: a symmetric matrix without negative
// eigenvalues. On the border between two cases, the derivative of one of them.
struct ConeProjection {
  ConeVector point;
  ConeMatrix derivative;
};

inline ConeProjection project_to_cone(const ConeVector& x, double friction) {
  ConeProjection result{ConeVector::Zero(), ConeMatrix::Zero()};
  const double normal = x[0];
  const double slip = x.tail<3>().norm();
  if (normal >= 0.0 && slip <= friction * normal) {
    result.point = x;
    result.derivative.setIdentity();
    return result;
  }
  // In the polar cone: the tip is nearest.
  if (friction * slip <= -normal) return result;
  // On the rim: along (1, mu t) with t the direction of the tangential part.
  ConeVector rim;
  rim << 1.0, friction / slip * x.tail<3>();
  const double along = (normal + friction * slip) / (1.0 + friction * friction);
  result.point = along * rim;
  result.derivative = rim * rim.transpose() / (1.0 + friction * friction);
  const Eigen::Vector3d t = x.tail<3>() / slip;
  result.derivative.bottomRightCorner<3, 3>() +=
      along * friction / slip * (Eigen::Matrix3d::Identity() - t * t.transpose());
  return result;
}

// The nearest number in an interval to the first of x, in the same form.
inline ConeProjection project_to_interval(const ConeVector& x, double lower, double upper) {
  ConeProjection result{ConeVector::Zero(), ConeMatrix::Zero()};
  result.point[0] = std::clamp(x[0], lower, upper);
  if (result.point[0] == x[0]) result.derivative(0, 0) = 1.0;
  return result;
}

}  // namespace prehend
