#include "primitives/turn_axis.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

#include "primitives/fit.h"

namespace prehend {
namespace {

// Directions across an axis.
struct Across {
  Vector3 x = Vector3::UnitX();
  Vector3 y = Vector3::UnitY();
};

Across across(const TurnAxis& axis) {
  const Vector3 x = axis.direction_O.unitOrthogonal();
  return {x, axis.direction_O.cross(x)};
}

Vector3 mean_point(std::span<const SurfacePoint> points) {
  Vector3 sum = Vector3::Zero();
  for (const SurfacePoint& s : points) sum += s.p_O;
  return sum / static_cast<double>(points.size());
}

// Sums over the lines of normals. A line through p along n has the moment p x n; its distance from
// the axis a through the origin plus m, times a factor, is a . (p x n) + m . n.
struct LineSums {
  Matrix3 moments = Matrix3::Zero();
  Matrix3 mixed = Matrix3::Zero();
  Matrix3 normals = Matrix3::Zero();
};

// The axis near `from` that the lines of the normals meet best, in the mean of the squared sines at
// which they pass it. Lines whose tangential part is beyond the cutoff do not count; a cutoff over
// 1 counts all alike.
TurnAxis refitted_axis(const TurnAxis& from, std::span<const SurfacePoint> points, double cutoff) {
  // Near the axis a normal says little about it.
  constexpr double kNear = 0.05;
  // Of a ball every axis is one: what lines leave open stays as it is.
  constexpr double kOpen = 1e-5;
  constexpr double kShiftOpen = 1e-9;
  const std::vector<SeenFromAxis> seen = seen_from(from, points);
  LineSums sums;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double robust = cutoff > 1.0 ? 1.0 : biweight(seen[i].tangential, cutoff);
    const double weight = robust / (seen[i].radius * seen[i].radius + kNear * kNear);
    const Vector3& n = points[i].n_O;
    const Vector3 moment = (points[i].p_O - from.p_O).cross(n);
    sums.moments += weight * moment * moment.transpose();
    sums.mixed += weight * n * moment.transpose();
    sums.normals += weight * n * n.transpose();
  }
  const auto [x, y] = across(from);
  Eigen::Matrix<double, 3, 2> plane;
  plane << x, y;
  const double size = sums.normals.trace();
  const Eigen::Matrix2d shifts =
      plane.transpose() * sums.normals * plane + kShiftOpen * size * Eigen::Matrix2d::Identity();
  const Eigen::Matrix<double, 2, 3> mixed = plane.transpose() * sums.mixed;
  const Eigen::Matrix<double, 2, 3> best_shift = shifts.inverse() * mixed;
  const Vector3& a = from.direction_O;
  const Matrix3 left = sums.moments - mixed.transpose() * best_shift +
                       kOpen * size * (Matrix3::Identity() - a * a.transpose());
  const Eigen::SelfAdjointEigenSolver<Matrix3> solver(left);
  TurnAxis to = from;
  to.direction_O = solver.eigenvectors().col(0);
  if (to.direction_O.dot(a) < 0.0) to.direction_O = -to.direction_O;
  const Vector3 m = -(plane * (best_shift * to.direction_O));
  to.p_O += to.direction_O.cross(m);
  return to;
}

// What patches of two sizes around a few points tell alone.
void add_starts_of_patches(std::span<const SurfacePoint> points, std::vector<TurnAxis>& starts) {
  constexpr std::size_t kPatches = 8;
  constexpr std::size_t kFewest = 30;
  constexpr int kSteps = 4;
  for (std::size_t k = 0; k < kPatches; ++k) {
    const Vector3& at = points[k * points.size() / kPatches].p_O;
    for (const double reach : {0.15, 0.3}) {
      std::vector<SurfacePoint> patch;
      for (const SurfacePoint& s : points) {
        if ((s.p_O - at).norm() < reach) patch.push_back(s);
      }
      if (patch.size() < kFewest) continue;
      TurnAxis axis{mean_point(patch), normal_axes(patch).col(0)};
      for (int i = 0; i < kSteps; ++i) axis = refitted_axis(axis, patch, i == 0 ? 2.0 : 0.7);
      starts.push_back(axis);
    }
  }
}

bool is_finite(const TurnAxis& axis) {
  return axis.p_O.allFinite() && axis.direction_O.allFinite();
}

// Whether two axes are nearly the same line, near the middle of the points.
bool is_alike(const TurnAxis& a, const TurnAxis& b, const Vector3& middle) {
  constexpr double kSameDirection = 0.9994;  // cosine; 2 degrees
  constexpr double kSameLine = 0.01;
  const auto nearest = [&](const TurnAxis& axis) -> Vector3 {
    return axis.p_O + (middle - axis.p_O).dot(axis.direction_O) * axis.direction_O;
  };
  return std::abs(a.direction_O.dot(b.direction_O)) > kSameDirection &&
         (nearest(a) - nearest(b)).norm() < kSameLine;
}

}  // namespace

std::vector<SeenFromAxis> seen_from(const TurnAxis& axis, std::span<const SurfacePoint> points) {
  const auto [x, y] = across(axis);
  std::vector<SeenFromAxis> seen;
  seen.reserve(points.size());
  for (const SurfacePoint& s : points) {
    const Vector3 d = s.p_O - axis.p_O;
    const double dx = d.dot(x);
    const double dy = d.dot(y);
    const double nx = s.n_O.dot(x);
    const double ny = s.n_O.dot(y);
    SeenFromAxis one;
    one.z = d.dot(axis.direction_O);
    one.radius = std::sqrt(dx * dx + dy * dy);
    one.angle = std::atan2(dy, dx);
    if (one.radius > 0.0) {
      one.outward = (nx * dx + ny * dy) / one.radius;
      one.tangential = (ny * dx - nx * dy) / one.radius;
    }
    seen.push_back(one);
  }
  return seen;
}

std::vector<TurnAxis> likely_axes(std::span<const SurfacePoint> points) {
  // The sine beyond which a normal does not belong, from step to step.
  constexpr std::array<double, 6> kCutoffs = {0.9, 0.7, 0.5, 0.5, 0.5, 0.5};
  constexpr std::size_t kPoints = 700;
  const std::vector<SurfacePoint> few = thinned(points, kPoints);
  const Vector3 middle = mean_point(few);
  std::vector<TurnAxis> starts;
  for (const Matrix3& axes : {point_axes(few), normal_axes(few)}) {
    for (int k = 0; k < 3; ++k) starts.push_back({middle, axes.col(k)});
  }
  add_starts_of_patches(few, starts);
  std::vector<TurnAxis> found;
  for (TurnAxis axis : starts) {
    for (const double cutoff : kCutoffs) {
      if (is_finite(axis)) axis = refitted_axis(axis, few, cutoff);
    }
    const bool known = std::any_of(found.begin(), found.end(), [&](const TurnAxis& other) {
      return is_alike(axis, other, middle);
    });
    if (is_finite(axis) && !known) found.push_back(axis);
  }
  return found;
}

}  // namespace prehend
