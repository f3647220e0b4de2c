// The friction cone {(p_n, p_t) : |p_t| <= mu p_n} and the nearest point in it.
#pragma once

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

namespace prehend {

// Up to four numbers: the normal, then two tangents and torsion, or none of these.
using ConeVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 4, 1>;
using ConeMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 4, 4>;

// The nearest point of the cone, and how it changes with x: a symmetric matrix without negative
// eigenvalues. On the border between two cases, the derivative of one of them.
struct ConeProjection {
  ConeVector point;
  ConeMatrix derivative;
};

inline ConeProjection project_to_cone(const ConeVector& x, double friction) {
  const Eigen::Index rows = x.size();
  ConeProjection result{ConeVector::Zero(rows), ConeMatrix::Zero(rows, rows)};
  const double normal = x[0];
  const double slip = rows > 1 ? x.tail(rows - 1).norm() : 0.0;
  if (normal >= 0.0 && slip <= friction * normal) {
    result.point = x;
    result.derivative.setIdentity();
    return result;
  }
  // In the polar cone: the tip is nearest.
  if (friction * slip <= -normal) return result;
  // On the rim: along (1, mu t) with t the direction of the tangential part.
  ConeVector rim = ConeVector::Zero(rows);
  rim[0] = 1.0;
  rim.tail(rows - 1) = friction / slip * x.tail(rows - 1);
  const double along = (normal + friction * slip) / (1.0 + friction * friction);
  result.point = along * rim;
  result.derivative = rim * rim.transpose() / (1.0 + friction * friction);
  const ConeVector t = x.tail(rows - 1) / slip;
  result.derivative.bottomRightCorner(rows - 1, rows - 1) +=
      along * friction / slip * (ConeMatrix::Identity(rows - 1, rows - 1) - t * t.transpose());
  return result;
}

// The nearest number in an interval, in the same form.
inline ConeProjection project_to_interval(const ConeVector& x, double lower, double upper) {
  ConeProjection result{ConeVector::Zero(1), ConeMatrix::Zero(1, 1)};
  result.point[0] = std::clamp(x[0], lower, upper);
  if (result.point[0] == x[0]) result.derivative(0, 0) = 1.0;
  return result;
}

}  // namespace prehend
