#include <algorithm>
#include <cmath>
#include <limits>

#include "primitives/fit_circle.h"
#include "primitives/fit_shapes.h"
#include "primitives/normal_equations.h"
#include "primitives/quantile.h"
#include "primitives/ranked_starts.h"

namespace prehend {
namespace {

// Like the box (fit_box.cpp): robust Gauss-Newton from the best of many starting axes. For a given
// axis, a circle through the projected points of the side gives the start; each step assigns every
// point to the side or a cap and solves for the axis, the radius and both caps together.

// A cylinder in the form that the fit changes.
struct Tube {
  Matrix3 R_OP = Matrix3::Identity();  // the axis is the third column
  Vector3 base = Vector3::Zero();      // a point of the axis
  double radius = 0.0;
  double low = 0.0;  // caps along the axis, from the base
  double high = 0.0;
};

enum class Part { side, high, low };

// A point relative to the cylinder. Of the signed distances from side and caps (positive outside)
// the largest counts: inside the cylinder that is the nearest part.
struct TubePoint {
  Vector3 q = Vector3::Zero();  // in the frame of the cylinder, from its base
  double rho = 0.0;             // distance from the axis
  Part part = Part::side;
  double residual = 0.0;  // signed distance from that part
};

TubePoint seen_from(const Tube& tube, const Vector3& p_O) {
  TubePoint seen;
  seen.q = tube.R_OP.transpose() * (p_O - tube.base);
  seen.rho = seen.q.head<2>().norm();
  seen.residual = seen.rho - tube.radius;
  if (seen.q.z() - tube.high > seen.residual) {
    seen.part = Part::high;
    seen.residual = seen.q.z() - tube.high;
  }
  if (tube.low - seen.q.z() > seen.residual) {
    seen.part = Part::low;
    seen.residual = tube.low - seen.q.z();
  }
  return seen;
}

// The outward normal, in O, of the part that the point belongs to.
Vector3 outward(const Tube& tube, const TubePoint& seen) {
  switch (seen.part) {
    case Part::high:
      return tube.R_OP.col(2);
    case Part::low:
      return -tube.R_OP.col(2);
    case Part::side:
      break;
  }
  if (!(seen.rho > 0.0)) return tube.R_OP.col(0);
  return (tube.R_OP.col(0) * seen.q.x() + tube.R_OP.col(1) * seen.q.y()) / seen.rho;
}

Primitive primitive_of(const Tube& tube, double min_extent) {
  const Vector3 center = tube.base + tube.R_OP.col(2) * (0.5 * (tube.low + tube.high));
  return {
      Cylinder{std::max(tube.radius, 0.5 * min_extent), std::max(tube.high - tube.low, min_extent)},
      pose_from(tube.R_OP, center)};
}

// The starting cylinder along `axis`. Its circle is fitted to the points whose normals are about
// orthogonal to the axis, since those of the caps would fill the circle. Its ends leave the
// fraction `tail` of all points outside on either side.
Tube tube_along(const Vector3& axis, std::span<const SurfacePoint> points, double tail) {
  // Cosine between normal and axis. A point of the side has 0; 0.6 leaves room for a starting axis
  // that is off by 35 degrees, and for cones.
  constexpr double kSideways = 0.6;
  Tube tube;
  tube.R_OP.col(2) = axis;
  tube.R_OP.col(0) = any_orthogonal(axis);
  tube.R_OP.col(1) = axis.cross(tube.R_OP.col(0));
  std::vector<double> along;
  std::vector<Eigen::Vector2d> sideways;
  double radius_sum = 0.0;
  for (const SurfacePoint& s : points) {
    const Vector3 q = tube.R_OP.transpose() * s.p_O;
    along.push_back(q.z());
    radius_sum += q.head<2>().norm();
    if (std::abs(s.n_O.dot(axis)) <= kSideways) sideways.emplace_back(q.head<2>());
  }
  tube.low = quantile(along, tail);
  tube.high = quantile(along, 1.0 - tail);
  tube.radius = radius_sum / static_cast<double>(points.size());
  if (const auto circle = fit_circle(std::move(sideways), tail)) {
    tube.base = tube.R_OP.leftCols<2>() * circle->center;
    tube.radius = circle->radius;
  }
  return tube;
}

std::vector<Tube> tube_starts(std::span<const SurfacePoint> points, const FitOptions& options) {
  constexpr int kDirections = 32;
  std::vector<Vector3> axes;
  for (const Matrix3& frame : {point_axes(points), normal_axes(points)}) {
    for (int i = 0; i < 3; ++i) axes.push_back(frame.col(i));
  }
  if (options.thorough) {
    for (const Vector3& d : half_sphere_directions(kDirections)) axes.push_back(d);
  }
  return ranked_starts(axes, points, options, tube_along, [](const Tube& tube, const Vector3& p_O) {
    return seen_from(tube, p_O).residual;
  });
}

// Unknowns: turns about the first two axes (0, 1), the base across the axis (2, 3), radius (4),
// caps (5 high, 6 low).
using TubeEquations = NormalEquations<7>;

// The derivative of the point's residual by each unknown. A turn w of the frame moves the point's
// coordinates by q x w. The residual of the side, rho - radius, changes by the part of this motion
// along (x, y) / rho, that of a cap by the part along the axis. A turn about the axis changes
// neither, so it is no unknown. On the axis itself rho has no derivative: such a point is left out
// of the step.
TubeEquations::Vector slope_of(const TubePoint& seen) {
  TubeEquations::Vector slope = TubeEquations::Vector::Zero();
  if (seen.part == Part::side) {
    if (!(seen.rho > 0.0)) return slope;
    const double ux = seen.q.x() / seen.rho;
    const double uy = seen.q.y() / seen.rho;
    slope << uy * seen.q.z(), -ux * seen.q.z(), -ux, -uy, -1.0, 0.0, 0.0;
  } else {
    const double sign = seen.part == Part::high ? 1.0 : -1.0;
    slope[0] = -sign * seen.q.y();
    slope[1] = sign * seen.q.x();
    slope[seen.part == Part::high ? 5 : 6] = -sign;
  }
  return slope;
}

// Moves an uncovered cap (the open end of a cup) to where the points near the side end, without the
// outermost 0.5 %.
void close_end(Tube& tube, Part end, std::span<const TubePoint> seen, double cutoff) {
  constexpr double kTail = 0.005;
  std::vector<double> along;
  for (const TubePoint& s : seen) {
    if (std::abs(s.rho - tube.radius) < cutoff) along.push_back(s.q.z());
  }
  if (along.empty()) return;
  if (end == Part::high) {
    tube.high = quantile(along, 1.0 - kTail);
  } else {
    tube.low = quantile(along, kTail);
  }
}

struct TubeSystem {
  TubeEquations equations;
  double side = 0.0;  // weight of the points on each part
  double high = 0.0;
  double low = 0.0;
  double loss = 0.0;  // as Step::loss_before
};

TubeSystem system_of(const Tube& tube, std::span<const SurfacePoint> points,
                     std::span<const TubePoint> seen, double cutoff, const FitOptions& options) {
  TubeSystem system;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double facing = facing_weight(points[i].n_O, outward(tube, seen[i]));
    const double weight = biweight(seen[i].residual, cutoff) * facing;
    system.loss += facing * point_loss(seen[i].residual, options.outlier);
    if (!(weight > 0.0)) continue;
    if (seen[i].part == Part::side) system.side += weight;
    if (seen[i].part == Part::high) system.high += weight;
    if (seen[i].part == Part::low) system.low += weight;
    const TubeEquations::Vector slope = slope_of(seen[i]);
    system.equations.normal += weight * slope * slope.transpose();
    system.equations.right -= (weight * seen[i].residual) * slope;
  }
  return system;
}

// One Gauss-Newton step of iteratively reweighted least squares, as in fit_box.cpp: each point
// pulls the part (side or cap) that it is nearest to, parts and weights are computed anew in every
// step.
Step improve(Tube& tube, std::span<const SurfacePoint> points, const FitOptions& options) {
  constexpr double kCovered = 0.25;
  std::vector<TubePoint> seen;
  std::vector<double> residuals;
  for (const SurfacePoint& s : points) {
    seen.push_back(seen_from(tube, s.p_O));
    residuals.push_back(seen.back().residual);
  }
  const double cutoff = robust_cutoff(residuals, options);
  TubeSystem system = system_of(tube, points, seen, cutoff, options);
  // A cap counts as open when it has less than a quarter of the points that its share of the area
  // would give it; a rim alone still leaves it some. Areas in units of pi * radius: a cap is
  // pi r^2 / (pi r) = r, the side 2 pi r h / (pi r) = 2 h.
  const double cap = tube.radius;
  const double side = 2.0 * std::max(tube.high - tube.low, 0.0);
  const double expected =
      (system.side + system.high + system.low) * cap / std::max(side + 2.0 * cap, 1e-300);
  if (!(system.high > kCovered * expected)) {
    system.equations.fix(5);
    close_end(tube, Part::high, seen, cutoff);
  }
  if (!(system.low > kCovered * expected)) {
    system.equations.fix(6);
    close_end(tube, Part::low, seen, cutoff);
  }
  const TubeEquations::Vector change = system.equations.damped_change();
  if (!change.allFinite()) return {system.loss, 0.0};
  tube.base += tube.R_OP.col(0) * change[2] + tube.R_OP.col(1) * change[3];
  turn_frame(tube.R_OP, Vector3(change[0], change[1], 0.0));
  tube.radius += change[4];
  tube.high += change[5];
  tube.low += change[6];
  return {system.loss, change.norm()};
}

}  // namespace

Primitive fit_cylinder(std::span<const SurfacePoint> points, const FitOptions& options) {
  constexpr double kConverged = 1e-10;
  // A nearly flat patch fits a cylinder of any radius; stay near the points' own extent.
  constexpr double kLargest = 3.0;
  // About the points' mean, so that turning the frame does not also move the cylinder.
  Vector3 mean = Vector3::Zero();
  for (const SurfacePoint& s : points) mean += s.p_O / static_cast<double>(points.size());
  std::vector<SurfacePoint> centered(points.begin(), points.end());
  double extent = 0.0;
  for (SurfacePoint& s : centered) {
    s.p_O -= mean;
    extent = std::max(extent, s.p_O.norm());
  }
  Tube best;
  double best_loss = std::numeric_limits<double>::infinity();
  for (Tube tube : tube_starts(centered, options)) {
    for (int i = 0; i <= options.steps; ++i) {
      // The loss belongs to the cylinder before the step: that is the one to keep.
      const Tube before = tube;
      const Step step = improve(tube, centered, options);
      if (step.loss_before < best_loss) {
        best = before;
        best_loss = step.loss_before;
      }
      if (step.change < kConverged) break;
      if (!(tube.radius > 0.0) || tube.radius > kLargest * extent || tube.high < tube.low) break;
    }
  }
  Primitive found = primitive_of(best, options.min_extent);
  found.X_OP.pretranslate(mean);
  return found;
}

}  // namespace prehend
