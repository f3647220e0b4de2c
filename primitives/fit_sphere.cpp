#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Cholesky>

#include "primitives/fit_shapes.h"
#include "primitives/point_columns.h"

namespace prehend {
namespace {

using Vector4 = Eigen::Vector4d;
using Matrix4 = Eigen::Matrix4d;

// Two starts, an algebraic fit and the mean ball, are each improved by robust Gauss-Newton, and the
// iterate of least loss is kept. The algebraic fit is exact for points of a sphere but is led
// astray by outliers; the mean ball is rough and always usable.

struct Ball {
  Vector3 center = Vector3::Zero();
  double radius = 0.0;
};

// Centre at the mean of the points, radius their mean distance from it.
Ball mean_ball(std::span<const SurfacePoint> points) {
  Ball ball;
  const double n = static_cast<double>(points.size());
  for (const SurfacePoint& s : points) ball.center += s.p_O / n;
  for (const SurfacePoint& s : points) ball.radius += (s.p_O - ball.center).norm() / n;
  return ball;
}

// Linear least squares on |p|^2 = 2 c.p + k, about the mean for conditioning.
Ball algebraic_ball(std::span<const SurfacePoint> points, const Ball& start) {
  Matrix4 normal = Matrix4::Zero();
  Vector4 right = Vector4::Zero();
  for (const SurfacePoint& s : points) {
    const Vector3 d = s.p_O - start.center;
    Vector4 row;
    row << 2.0 * d, 1.0;
    normal += row * row.transpose();
    right += row * d.squaredNorm();
  }
  const Vector4 x = normal.ldlt().solve(right);
  const Vector3 shift = x.head<3>();
  const double squared = x[3] + shift.squaredNorm();
  if (!x.allFinite() || !(squared > 0.0)) return start;
  return {start.center + shift, std::sqrt(squared)};
}

// The sphere with its radius kept between the allowed extents.
Primitive primitive_of(const Ball& ball, double largest, double smallest) {
  const double radius = std::max(std::min(ball.radius, largest), 0.5 * smallest);
  return {Sphere{radius}, translation(ball.center)};
}

// Sums over the points, of their weights times the products of their residuals r and of the
// direction d from the centre to them (of length 1).
struct BallSums {
  double one = 0.0;
  double loss = 0.0;  // as Step::loss_before
  double r = 0.0;
  Vector3 d = Vector3::Zero();
  Vector3 rd = Vector3::Zero();
  Vector3 squares = Vector3::Zero();   // xx, yy, zz
  Vector3 products = Vector3::Zero();  // yz, zx, xy
};

BallSums sums_of(const Ball& ball, const PointColumns& points, const FitOptions& options) {
  const Eigen::MatrixX3d from_center = points.p.rowwise() - ball.center.transpose();
  const Eigen::ArrayXd reach = from_center.rowwise().norm();
  const Eigen::ArrayXd residuals = reach - ball.radius;
  const double cutoff = robust_cutoff(residuals, options);
  BallSums sums;
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    // At the centre itself there is no direction, and none counts.
    const double inverse = reach[i] > 0.0 ? 1.0 / reach[i] : 0.0;
    const double x = inverse * from_center(i, 0);
    const double y = inverse * from_center(i, 1);
    const double z = inverse * from_center(i, 2);
    const double facing = facing_weight(points.n.row(i), {x, y, z});
    sums.loss += facing * point_loss(residuals[i], options.outlier);
    const double weight = biweight(residuals[i], cutoff) * facing;
    if (!(weight > 0.0)) continue;
    const double r = weight * residuals[i];
    sums.one += weight;
    sums.r += r;
    sums.d += Vector3(weight * x, weight * y, weight * z);
    sums.rd += Vector3(r * x, r * y, r * z);
    sums.squares += Vector3(weight * x * x, weight * y * y, weight * z * z);
    sums.products += Vector3(weight * y * z, weight * z * x, weight * x * y);
  }
  return sums;
}

struct Change {
  Vector4 unknowns = Vector4::Zero();  // centre, radius
  Step step;
};

// One step of iteratively reweighted least squares on the distances from the sphere. The derivative
// of |p - c| - r is -(p - c) / |p - c| by the centre and -1 by the radius.
Change gauss_newton(const Ball& ball, const PointColumns& points, const FitOptions& options) {
  const BallSums sums = sums_of(ball, points, options);
  Change change;
  change.step.loss_before = sums.loss;
  Matrix4 normal;
  normal << sums.squares.x(), sums.products.z(), sums.products.y(), sums.d.x(),  //
      sums.products.z(), sums.squares.y(), sums.products.x(), sums.d.y(),        //
      sums.products.y(), sums.products.x(), sums.squares.z(), sums.d.z(),        //
      sums.d.x(), sums.d.y(), sums.d.z(), sums.one;
  Vector4 right;
  right << sums.rd, sums.r;
  // Damping keeps the equations solvable where the points do not determine the sphere (flat patch).
  constexpr double kDamping = 1e-6;
  normal.diagonal() += Vector4::Constant(kDamping * normal.trace() + 1e-300);
  const Vector4 unknowns = normal.ldlt().solve(right);
  if (!unknowns.allFinite()) return change;
  change.unknowns = unknowns;
  change.step.change = unknowns.norm();
  return change;
}

}  // namespace

Primitive fit_sphere(std::span<const SurfacePoint> points, const FitOptions& options) {
  // A flat patch fits a sphere of any size; keep those that resemble the points' own extent.
  constexpr double kLargest = 3.0;
  constexpr double kConverged = 1e-9;
  const Ball mean = mean_ball(points);
  const double largest = kLargest * mean.radius;
  const PointColumns columns = columns_about(Vector3::Zero(), points);
  Ball best = mean;
  double best_loss = std::numeric_limits<double>::infinity();
  for (Ball ball : {algebraic_ball(points, mean), mean}) {
    for (int i = 0; i <= options.steps; ++i) {
      // A ball beyond these limits is not kept: its loss is not computed.
      if (!(ball.radius > 0.0) || ball.radius > largest) break;
      const Change change = gauss_newton(ball, columns, options);
      if (change.step.loss_before < best_loss) {
        best = ball;
        best_loss = change.step.loss_before;
      }
      if (change.step.change < kConverged * ball.radius) break;
      ball.center += change.unknowns.head<3>();
      ball.radius += change.unknowns[3];
    }
  }
  return primitive_of(best, largest, options.min_extent);
}

}  // namespace prehend
