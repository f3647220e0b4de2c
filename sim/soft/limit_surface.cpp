#include "sim/soft/limit_surface.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace prehend {
namespace {

// Directions and ratios of turning to sliding at which the surface is sampled for the fit.
constexpr int kSamples = 16;

// A point in the plane of the patch, from the centre of pressure.
struct PlanePoint {
  Eigen::Vector2d at;  // [m]
  double share = 0.0;  // of the load
};

std::vector<PlanePoint> in_plane(std::span<const PressedPoint> points,
                                 const LimitSurface& surface) {
  const Vector3 first = any_orthogonal(surface.normal);
  const Vector3 second = surface.normal.cross(first);
  double sum = 0.0;
  for (const PressedPoint& point : points) sum += point.force;
  std::vector<PlanePoint> plane;
  for (const PressedPoint& point : points) {
    const Vector3 from_center = point.position - surface.center;
    plane.push_back({{first.dot(from_center), second.dot(from_center)}, point.force / sum});
  }
  return plane;
}

// Friction of a motion that slides by `velocity` and turns by `turning` about the centre.
LimitLoad load_of(std::span<const PlanePoint> points, const Eigen::Vector2d& velocity,
                  double turning) {
  LimitLoad load;
  for (const PlanePoint& point : points) {
    const Eigen::Vector2d slip = velocity + turning * Eigen::Vector2d(-point.at.y(), point.at.x());
    const double speed = slip.norm();
    if (speed == 0.0) continue;
    const Eigen::Vector2d force = point.share / speed * slip;
    load.force += force;
    load.torque += point.at.x() * force.y() - point.at.y() * force.x();
  }
  return load;
}

std::vector<LimitLoad> sample(std::span<const PlanePoint> points, int count) {
  double radius = 0.0;  // mean distance from the centre: makes turning comparable to sliding [m]
  for (const PlanePoint& point : points) radius += point.share * point.at.norm();
  std::vector<LimitLoad> loads;
  if (radius == 0.0) return loads;
  for (int i = 0; i < count; ++i) {
    const double direction = 2.0 * std::numbers::pi * i / count;
    const Eigen::Vector2d unit(std::cos(direction), std::sin(direction));
    for (int k = 0; k < count; ++k) {
      const double ratio = std::numbers::pi * (k + 0.5) / count - 0.5 * std::numbers::pi;
      loads.push_back(load_of(points, std::cos(ratio) * unit, std::sin(ratio) / radius));
    }
  }
  return loads;
}

// The half-axis T of the ellipsoid |f|^2 + (t / T)^2 = 1 with the least squares of its equation.
double fit_torsion(std::span<const LimitLoad> loads) {
  double numerator = 0.0;
  double denominator = 0.0;
  for (const LimitLoad& load : loads) {
    const double torque = load.torque * load.torque;
    numerator += torque * (1.0 - load.force.squaredNorm());
    denominator += torque * torque;
  }
  return denominator > 0.0 && numerator > 0.0 ? std::sqrt(denominator / numerator) : 0.0;
}

}  // namespace

LimitSurface limit_surface(std::span<const PressedPoint> points) {
  LimitSurface surface;
  Vector3 force = Vector3::Zero();
  Vector3 moment = Vector3::Zero();
  double sum = 0.0;
  for (const PressedPoint& point : points) {
    force += point.force * point.normal;
    moment += point.force * point.position;
    sum += point.force;
  }
  surface.center = moment / sum;
  surface.load = force.norm();
  surface.normal = force / surface.load;
  const std::vector<PlanePoint> plane = in_plane(points, surface);
  surface.torsion = std::abs(load_of(plane, Eigen::Vector2d::Zero(), 1.0).torque);
  const std::vector<LimitLoad> loads = sample(plane, kSamples);
  surface.fitted_torsion = fit_torsion(loads);
  if (surface.fitted_torsion == 0.0) return surface;
  for (const LimitLoad& load : loads) {
    const double size = std::hypot(load.force.norm(), load.torque / surface.fitted_torsion);
    surface.error = std::max(surface.error, std::abs(size - 1.0));
  }
  return surface;
}

std::vector<LimitLoad> limit_loads(std::span<const PressedPoint> points,
                                   const LimitSurface& surface, int count) {
  return sample(in_plane(points, surface), count);
}

}  // namespace prehend
