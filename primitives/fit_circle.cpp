#include "primitives/fit_circle.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include "primitives/quantile.h"

// The algebraic circle fit (Kasa 1976): the equation of a circle, |p - c|^2 = r^2, is linear in the
// centre c and in k = r^2 - |c|^2, so that one linear least squares problem solves it without a
// start. Points far away have a large weight in it, because their squared distances are fitted. So
// the points farthest from the median are left out first.
namespace prehend {
namespace {

using Vector2 = Eigen::Vector2d;

Vector2 median_of(const std::vector<Vector2>& points) {
  Vector2 median;
  std::vector<double> values(points.size());
  for (int axis = 0; axis < 2; ++axis) {
    std::transform(points.begin(), points.end(), values.begin(),
                   [axis](const Vector2& p) { return p[axis]; });
    median[axis] = quantile(values, 0.5);
  }
  return median;
}

}  // namespace

std::optional<Circle> fit_circle(std::vector<Vector2> points, double tail) {
  constexpr std::size_t kFewest = 3;
  if (points.size() < kFewest) return std::nullopt;
  const Vector2 median = median_of(points);
  std::vector<double> reaches(points.size());
  std::transform(points.begin(), points.end(), reaches.begin(),
                 [&median](const Vector2& p) { return (p - median).norm(); });
  const double reach = quantile(reaches, 1.0 - tail);
  // Linear least squares on |p|^2 = 2 c.p + k, about the median for conditioning.
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const Vector2& p : points) {
    const Vector2 d = p - median;
    if (d.norm() > reach) continue;
    const Eigen::Vector3d row(2.0 * d.x(), 2.0 * d.y(), 1.0);
    normal += row * row.transpose();
    right += row * d.squaredNorm();
  }
  // |p - c|^2 = r^2 is |p|^2 = 2 c.p + (r^2 - |c|^2): linear in c and k = r^2 - |c|^2.
  const Eigen::Vector3d x = normal.ldlt().solve(right);
  const double squared = x[2] + x.head<2>().squaredNorm();
  // Points on a nearly straight line fit a huge circle, whose centre says nothing about an axis.
  constexpr double kLargest = 4.0;
  if (!x.allFinite() || !(squared > 0.0) || !(std::sqrt(squared) < kLargest * reach)) {
    return std::nullopt;
  }
  return Circle{median + x.head<2>(), std::sqrt(squared)};
}

}  // namespace prehend
