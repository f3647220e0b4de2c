#include "primitives/fit.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Eigenvalues>

#include "primitives/quantile.h"

// The robust statistics of the fits. Least squares would let a few points of other parts of the
// object (a handle beside a body) move a primitive far from the rest. Residuals are therefore
// weighted with Tukey's biweight, whose cutoff follows from the median of the residuals, and the
// shapes themselves are compared by a loss that is constant beyond the tolerance.
namespace prehend {
namespace {

// Eigenvectors as columns, sorted by eigenvalue, smallest first; the identity for a matrix that has
// no finite ones.
Matrix3 right_handed_eigenvectors(const Matrix3& symmetric) {
  Eigen::SelfAdjointEigenSolver<Matrix3> solver;
  solver.computeDirect(symmetric);
  Matrix3 axes = solver.eigenvectors();
  if (!axes.allFinite()) return Matrix3::Identity();
  // The closed-form solver is fast, but its vectors are not orthogonal where eigenvalues are close:
  // Gram-Schmidt makes them so.
  axes.col(0).normalize();
  axes.col(1) = (axes.col(1) - axes.col(0) * axes.col(0).dot(axes.col(1))).normalized();
  if (!axes.allFinite() || axes.col(1).norm() < 0.5) axes.col(1) = any_orthogonal(axes.col(0));
  axes.col(2) = axes.col(0).cross(axes.col(1));
  return axes;
}

}  // namespace

std::span<const double> starting_tails(const FitOptions& options) {
  static constexpr std::array<double, 2> kTails = {0.01, 0.15};
  return std::span(kTails).first(options.thorough ? 2 : 1);
}

double misfit(std::span<const SurfacePoint> points, const Primitive& primitive, double tolerance) {
  if (points.empty()) return 0.0;
  double sum = 0.0;
  for (const SurfacePoint& s : points) {
    sum += point_loss(signed_distance(primitive, s.p_O), tolerance);
  }
  return sum / static_cast<double>(points.size());
}

std::vector<SurfacePoint> thinned(std::span<const SurfacePoint> points, std::size_t count) {
  if (points.size() <= count) return {points.begin(), points.end()};
  std::vector<SurfacePoint> kept;
  kept.reserve(count);
  for (std::size_t i = 0; i < count; ++i) kept.push_back(points[i * points.size() / count]);
  return kept;
}

double robust_cutoff(const Eigen::ArrayXd& residuals, const FitOptions& options) {
  // Up to this share of the tolerance a residual is tessellation, a rounded edge or a start that is
  // not there yet, not an outlier.
  constexpr double kLowest = 0.4;
  const double lowest = kLowest * options.outlier;
  const double highest = 2.0 * options.outlier;
  if (residuals.size() == 0) return lowest;
  // Where the median gives one of these two, it need not be known: it is enough to count. Between
  // them lie few of the residuals, and the median is looked for among those only.
  std::vector<double> between(static_cast<std::size_t>(residuals.size()));
  std::size_t count = 0;
  std::size_t below = 0;
  std::size_t within = 0;
  for (const double residual : residuals) {
    const double size = std::abs(residual);
    const bool low = kCutoffMedians * size <= lowest;
    const bool high = kCutoffMedians * size >= highest;
    between[count] = size;
    count += low || high ? 0U : 1U;
    below += low ? 1U : 0U;
    within += size <= options.outlier ? 1U : 0U;
  }
  const std::size_t place = quantile_place(between.size(), 0.5);
  if (place < below) return lowest;
  if (place < below + count) {
    return kCutoffMedians * value_at_place(std::span(between).first(count), place - below);
  }
  if (place < within) return highest;
  std::transform(residuals.begin(), residuals.end(), between.begin(),
                 [](double r) { return std::abs(r); });
  return 2.0 * std::max(options.outlier, value_at_place(between, place));
}

Matrix3 point_axes(std::span<const SurfacePoint> points) {
  Vector3 mean = Vector3::Zero();
  for (const SurfacePoint& s : points) mean += s.p_O;
  mean /= static_cast<double>(std::max<std::size_t>(points.size(), 1));
  Matrix3 scatter = Matrix3::Zero();
  for (const SurfacePoint& s : points) {
    const Vector3 d = s.p_O - mean;
    scatter += d * d.transpose();
  }
  return right_handed_eigenvectors(scatter);
}

Matrix3 normal_axes(std::span<const SurfacePoint> points) {
  Matrix3 scatter = Matrix3::Zero();
  for (const SurfacePoint& s : points) scatter += s.n_O * s.n_O.transpose();
  return right_handed_eigenvectors(scatter);
}

}  // namespace prehend
