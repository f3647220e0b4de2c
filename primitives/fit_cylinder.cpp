#include <algorithm>
#include <cmath>
#include <limits>

#include "primitives/fit_circle.h"
#include "primitives/fit_shapes.h"
#include "primitives/normal_equations.h"
#include "primitives/quantile.h"
#include "primitives/ranked_starts.h"
#include "sim/shape/sphere_directions.h"

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

// The points relative to the cylinder. Of a point's signed distances from side and caps (positive
// outside) the largest counts: inside the cylinder that is the nearest part.
struct TubeView {
  Eigen::MatrixX3d q;        // in the frame of the cylinder, from its base
  Eigen::ArrayXd rho;        // distances from the axis
  Eigen::ArrayXd residuals;  // signed distances from the nearest part
};

TubeView seen_from(const Tube& tube, const PointColumns& points) {
  TubeView seen{in_frame(tube.R_OP, points.p), {}, {}};
  seen.q.rowwise() -= tube.base.transpose() * tube.R_OP;
  seen.rho = (seen.q.col(0).array().square() + seen.q.col(1).array().square()).sqrt();
  const auto z = seen.q.col(2).array();
  seen.residuals = (seen.rho - tube.radius).max(z - tube.high).max(tube.low - z);
  return seen;
}

Part nearest_part(const Tube& tube, double rho, double z) {
  const double side = rho - tube.radius;
  const double high = z - tube.high;
  const double low = tube.low - z;
  if (low > std::max(side, high)) return Part::low;
  return high > side ? Part::high : Part::side;
}

// The outward normal, in the cylinder's frame, of the part that the point q belongs to.
Vector3 outward(Part part, const Vector3& q, double rho) {
  if (part == Part::high) return Vector3::UnitZ();
  if (part == Part::low) return -Vector3::UnitZ();
  if (!(rho > 0.0)) return Vector3::UnitX();
  return {q.x() / rho, q.y() / rho, 0.0};
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
Tube tube_along(const Vector3& axis, const PointColumns& points, double tail) {
  // Cosine between normal and axis. A point of the side has 0; 0.6 leaves room for a starting axis
  // that is off by 35 degrees, and for cones.
  constexpr double kSideways = 0.6;
  Tube tube;
  tube.R_OP.col(2) = axis;
  tube.R_OP.col(0) = any_orthogonal(axis);
  tube.R_OP.col(1) = axis.cross(tube.R_OP.col(0));
  Eigen::MatrixX3d q = in_frame(tube.R_OP, points.p);
  const Eigen::ArrayXd along_normal = points.n.lazyProduct(axis).array().abs();
  std::vector<Eigen::Vector2d> sideways;
  sideways.reserve(static_cast<std::size_t>(q.rows()));
  for (Eigen::Index i = 0; i < q.rows(); ++i) {
    if (along_normal[i] <= kSideways) sideways.emplace_back(q(i, 0), q(i, 1));
  }
  const std::span<double> along(q.col(2).data(), static_cast<std::size_t>(q.rows()));
  tube.low = quantile(along, tail);
  tube.high = quantile(along, 1.0 - tail);
  if (const auto circle = fit_circle(std::move(sideways), tail)) {
    tube.base = tube.R_OP.leftCols<2>() * circle->center;
    tube.radius = circle->radius;
  } else {
    tube.radius = (q.col(0).array().square() + q.col(1).array().square()).sqrt().mean();
  }
  return tube;
}

std::vector<Tube> tube_starts(std::span<const SurfacePoint> points, const PointColumns& columns,
                              const FitOptions& options) {
  constexpr int kDirections = 32;
  std::vector<Vector3> axes;
  for (const Matrix3& frame : {point_axes(points), normal_axes(points)}) {
    for (int i = 0; i < 3; ++i) axes.push_back(frame.col(i));
  }
  if (options.thorough) {
    for (const Vector3& d : half_sphere_directions(kDirections)) axes.push_back(d);
  }
  return ranked_starts(
      axes, columns, options, tube_along,
      [](const Tube& tube, const PointColumns& few) { return seen_from(tube, few).residuals; });
}

// Unknowns: turns about the first two axes (0, 1), the base across the axis (2, 3), radius (4),
// caps (5 high, 6 low).
using TubeEquations = NormalEquations<7>;

// Sums over the points of the side, of their weights times the products of their residuals r, of
// x and y, the coordinates of the direction from the axis (of length 1), and of z, the coordinate
// along it.
struct SideSums {
  double one = 0.0;
  double x = 0.0;
  double y = 0.0;
  double xz = 0.0;
  double yz = 0.0;
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  double xxz = 0.0;
  double xyz = 0.0;
  double yyz = 0.0;
  double xxzz = 0.0;
  double xyzz = 0.0;
  double yyzz = 0.0;
  double r = 0.0;
  double rx = 0.0;
  double ry = 0.0;
  double rxz = 0.0;
  double ryz = 0.0;
};

// On the axis itself the distance from it has no derivative: such a point is left out.
void add_point(SideSums& sums, const Vector3& q, double rho, double residual, double weight) {
  if (!(rho > 0.0)) return;
  const double x = q.x() / rho;
  const double y = q.y() / rho;
  const double z = q.z();
  const double r = weight * residual;
  const double xx = weight * x * x;
  const double xy = weight * x * y;
  const double yy = weight * y * y;
  sums.one += weight;
  sums.x += weight * x;
  sums.y += weight * y;
  sums.xz += weight * x * z;
  sums.yz += weight * y * z;
  sums.xx += xx;
  sums.xy += xy;
  sums.yy += yy;
  sums.xxz += xx * z;
  sums.xyz += xy * z;
  sums.yyz += yy * z;
  sums.xxzz += xx * z * z;
  sums.xyzz += xy * z * z;
  sums.yyzz += yy * z * z;
  sums.r += r;
  sums.rx += r * x;
  sums.ry += r * y;
  sums.rxz += r * x * z;
  sums.ryz += r * y * z;
}

// A turn w of the frame moves a point's coordinates by q x w. The residual of the side, its
// distance from the axis less the radius, changes by the part of this motion along (x, y), that of
// a cap by the part along the axis. A turn about the axis changes neither, so it is no unknown. So
// the slopes of a point of the side are (y z, -x z, -x, -y, -1).
void add_side(TubeEquations& equations, const SideSums& sums) {
  Eigen::Matrix<double, 5, 5> lower = Eigen::Matrix<double, 5, 5>::Zero();
  lower.col(0) << sums.yyzz, -sums.xyzz, -sums.xyz, -sums.yyz, -sums.yz;
  lower.col(1).tail<4>() << sums.xxzz, sums.xxz, sums.xyz, sums.xz;
  lower.col(2).tail<3>() << sums.xx, sums.xy, sums.x;
  lower.col(3).tail<2>() << sums.yy, sums.y;
  lower(4, 4) = sums.one;
  equations.normal.topLeftCorner<5, 5>() += lower;
  Eigen::Matrix<double, 5, 1> right;
  right << -sums.ryz, sums.rxz, sums.rx, sums.ry, sums.r;
  equations.right.head<5>() += right;
}

// Sums over the points of one cap, of their weights times the products of their residuals r and
// their coordinates x, y.
struct CapSums {
  double one = 0.0;
  double x = 0.0;
  double y = 0.0;
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  double r = 0.0;
  double rx = 0.0;
  double ry = 0.0;
};

void add_point(CapSums& sums, const Vector3& q, double residual, double weight) {
  const double r = weight * residual;
  sums.one += weight;
  sums.x += weight * q.x();
  sums.y += weight * q.y();
  sums.xx += weight * q.x() * q.x();
  sums.xy += weight * q.x() * q.y();
  sums.yy += weight * q.y() * q.y();
  sums.r += r;
  sums.rx += r * q.x();
  sums.ry += r * q.y();
}

// The slopes of a cap's points are -sign (y, -x, 1), with sign 1 for the high cap and -1 for the
// low one.
void add_cap(TubeEquations& equations, int unknown, double sign, const CapSums& sums) {
  equations.normal(0, 0) += sums.yy;
  equations.normal(1, 0) -= sums.xy;
  equations.normal(1, 1) += sums.xx;
  equations.normal(unknown, 0) += sums.y;
  equations.normal(unknown, 1) -= sums.x;
  equations.normal(unknown, unknown) += sums.one;
  equations.right[0] += sign * sums.ry;
  equations.right[1] -= sign * sums.rx;
  equations.right[unknown] += sign * sums.r;
}

// Moves an uncovered cap (the open end of a cup) to where the points near the side end, without the
// outermost 0.5 %.
void close_end(Tube& tube, Part end, const TubeView& seen, double cutoff) {
  constexpr double kTail = 0.005;
  std::vector<double> along;
  for (Eigen::Index i = 0; i < seen.rho.size(); ++i) {
    if (std::abs(seen.rho[i] - tube.radius) < cutoff) along.push_back(seen.q(i, 2));
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

TubeSystem system_of(const Tube& tube, const PointColumns& points, const TubeView& seen,
                     double cutoff, const FitOptions& options) {
  TubeSystem system;
  SideSums side;
  CapSums high;
  CapSums low;
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    const Vector3 q = seen.q.row(i);
    const double rho = seen.rho[i];
    const double residual = seen.residuals[i];
    const Part part = nearest_part(tube, rho, q.z());
    const double facing = facing_weight(points.n.row(i), tube.R_OP * outward(part, q, rho));
    system.loss += facing * point_loss(residual, options.outlier);
    const double weight = biweight(residual, cutoff) * facing;
    if (!(weight > 0.0)) continue;
    if (part == Part::side) {
      add_point(side, q, rho, residual, weight);
    } else {
      add_point(part == Part::high ? high : low, q, residual, weight);
    }
  }
  add_side(system.equations, side);
  add_cap(system.equations, 5, 1.0, high);
  add_cap(system.equations, 6, -1.0, low);
  system.side = side.one;
  system.high = high.one;
  system.low = low.one;
  return system;
}

// One Gauss-Newton step of iteratively reweighted least squares, as in fit_box.cpp: each point
// pulls the part (side or cap) that it is nearest to, parts and weights are computed anew in every
// step.
Step improve(Tube& tube, const PointColumns& points, const FitOptions& options) {
  constexpr double kCovered = 0.25;
  const TubeView seen = seen_from(tube, points);
  const double cutoff = robust_cutoff(seen.residuals, options);
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
  const PointColumns centered = columns_about(mean, points);
  const double extent = centered.p.rowwise().norm().maxCoeff();
  Tube best;
  double best_loss = std::numeric_limits<double>::infinity();
  for (Tube tube : tube_starts(points, centered, options)) {
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
