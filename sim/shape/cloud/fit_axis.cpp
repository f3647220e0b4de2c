#include "sim/shape/cloud/fit_axis.h"

#include <algorithm>
#include <cmath>

#include "sim/shape/sphere_directions.h"

namespace prehend {
namespace {

constexpr int kDirections = 120;    // over half the sphere
constexpr double kNeighbour = 0.3;  // angle of directions that count as one [rad]

}  // namespace

AxisFit fit_axis(const std::vector<SeenPoint>& points, const Vector3& direction) {
  const Vector3 x = any_orthogonal(direction);
  const Vector3 y = direction.cross(x);
  Eigen::Vector2d at = Eigen::Vector2d::Zero();
  double misfit = kMostMiss;
  for (int round = 0; round < 5; ++round) {
    Eigen::Matrix2d left = 1e-9 * Eigen::Matrix2d::Identity();
    Eigen::Vector2d right = 1e-9 * at;
    double sum = 0.0;
    double weights = 0.0;
    for (const SeenPoint& point : points) {
      const Eigen::Vector2d n(x.dot(point.normal_P), y.dot(point.normal_P));
      const double size = n.norm();
      if (size < 0.15) continue;
      const Eigen::Vector2d across(-n.y() / size, n.x() / size);
      const double here = across.dot(Eigen::Vector2d(x.dot(point.p_P), y.dot(point.p_P)));
      const double miss = std::abs(across.dot(at) - here);
      sum += size * std::min(miss, kMostMiss);
      weights += size;
      // Cauchy's weight, from the second round on.
      const double scaled = miss / 3e-3;
      const double weight = round == 0 ? size : size / (1.0 + scaled * scaled);
      left += weight * across * across.transpose();
      right += weight * here * across;
    }
    if (weights <= 0.05 * static_cast<double>(points.size())) break;
    if (round > 0) misfit = sum / weights;
    at = left.ldlt().solve(right);
  }
  return {direction, at.x() * x + at.y() * y, misfit};
}

std::vector<AxisFit> find_axes(const std::vector<SeenPoint>& points, std::size_t count) {
  std::vector<AxisFit> fits;
  for (const Vector3& direction : half_sphere_directions(kDirections)) {
    fits.push_back(fit_axis(points, direction));
  }
  std::stable_sort(fits.begin(), fits.end(),
                   [](const AxisFit& a, const AxisFit& b) { return a.misfit < b.misfit; });
  std::vector<AxisFit> best;
  for (const AxisFit& fit : fits) {
    if (best.size() == count) break;
    const bool known = std::any_of(best.begin(), best.end(), [&](const AxisFit& other) {
      return std::abs(other.direction.dot(fit.direction)) > std::cos(kNeighbour);
    });
    if (!known) best.push_back(fit);
  }
  return best;
}

}  // namespace prehend
