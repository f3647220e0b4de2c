#include "primitives/taper.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "primitives/fit.h"

namespace prehend {
namespace {

// A point of the side: its place along the axis and its distance from it.
struct SidePoint {
  double z = 0.0;
  double rho = 0.0;
};

// The radius as a line over the place along the axis.
struct Line {
  double middle = 0.0;  // at z = 0
  double slope = 0.0;

  double at(double z) const { return middle + slope * z; }
};

// Points whose normal leads away from the axis: not those of the ends, nor of the inside of a
// wall.
std::vector<SidePoint> side_points(const Pose& X_OP, double height,
                                   std::span<const SurfacePoint> points) {
  constexpr double kSideways = 0.5;  // cosine between normal and the direction from the axis
  const Pose X_PO = X_OP.inverse();
  std::vector<SidePoint> side;
  for (const SurfacePoint& s : points) {
    const Vector3 p = X_PO * s.p_O;
    const Vector3 n = X_PO.linear() * s.n_O;
    const double rho = p.head<2>().norm();
    if (std::abs(p.z()) > 0.5 * height || !(rho > 0.0)) continue;
    if (n.head<2>().dot(p.head<2>()) > kSideways * rho) side.push_back({p.z(), rho});
  }
  return side;
}

// Iteratively reweighted least squares: what stands off the side, such as a handle, counts less and
// less.
std::optional<Line> fitted_line(const std::vector<SidePoint>& side, Line line, double tolerance) {
  constexpr int kRounds = 10;
  constexpr double kLeastSpread = 1e-12;
  double cutoff = 8.0 * tolerance;
  for (int round = 0; round < kRounds; ++round) {
    double w = 0.0;
    double z = 0.0;
    double r = 0.0;
    double zz = 0.0;
    double zr = 0.0;
    for (const SidePoint& point : side) {
      const double weight = biweight(point.rho - line.at(point.z), cutoff);
      w += weight;
      z += weight * point.z;
      r += weight * point.rho;
      zz += weight * point.z * point.z;
      zr += weight * point.z * point.rho;
    }
    const double spread = w * zz - z * z;
    if (!(spread > kLeastSpread * w * w)) return std::nullopt;
    line.slope = (w * zr - z * r) / spread;
    line.middle = (r - line.slope * z) / w;
    cutoff = std::max(0.7 * cutoff, tolerance);
  }
  return line;
}

}  // namespace

Primitive tapered(const Primitive& primitive, std::span<const SurfacePoint> points,
                  double tolerance) {
  constexpr double kBetter = 0.7;
  constexpr double kLeastTaper = 0.15;
  const auto* cylinder = std::get_if<Cylinder>(&primitive.shape);
  if (cylinder == nullptr) return primitive;
  const std::vector<SidePoint> side = side_points(primitive.X_OP, cylinder->height, points);
  const std::optional<Line> line = fitted_line(side, {cylinder->radius, 0.0}, tolerance);
  if (!line) return primitive;
  const double half = 0.5 * cylinder->height;
  const Cone cone{std::max(line->at(-half), 0.0), std::max(line->at(half), 0.0), cylinder->height};
  const double mean = 0.5 * (cone.radius_low + cone.radius_high);
  if (!(std::abs(cone.radius_high - cone.radius_low) >= kLeastTaper * mean)) return primitive;
  const Primitive found{cone, primitive.X_OP};
  const bool better =
      misfit(points, found, tolerance) <= kBetter * misfit(points, primitive, tolerance);
  return better ? found : primitive;
}

}  // namespace prehend
