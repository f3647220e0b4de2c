// What the fits of the three kinds of primitive share: options, robust statistics and starting
// directions. Points are in the frame O of the surface; lengths in its unit.
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "primitives/surface_sample.h"
#include "sim/shape/primitive.h"

namespace prehend {

// Settings of a fit.
struct FitOptions {
  // Distance (m, > 0) beyond which a point counts as not belonging to the primitive.
  double outlier = 0.0;
  // No extent of a primitive becomes smaller than this (m, > 0).
  double min_extent = 0.0;
  // Gauss-Newton steps from each start.
  int steps = 10;
  // Also start from directions spread over the half-sphere, for points whose principal axes and
  // normals do not show the axes of the primitive.
  bool thorough = true;
};

// The result of one Gauss-Newton step.
struct Step {
  double loss_before = 0.0;  // of the shape before the step: facing_weight * point_loss, summed
  double change = 0.0;       // size of the change in the unknowns
};

// The fractions of points that a starting shape leaves outside at each end. A small one against
// noise and, for thorough fits, one as large as a handle or a spout, so that such a protrusion does
// not blow up the start.
std::span<const double> starting_tails(const FitOptions& options);

// The cost of a point at this distance from the nearest primitive's surface: 1 beyond the
// tolerance, 0.4 (distance / tolerance)^2 within it. The jump from 0.4 to 1 makes a primitive that
// explains new surface worth more than one that only comes closer to surface that is explained
// already.
inline double point_loss(double distance, double tolerance) {
  constexpr double kAtTolerance = 0.4;
  const double relative = distance / tolerance;
  return std::abs(relative) < 1.0 ? kAtTolerance * relative * relative : 1.0;
}

// Mean of point_loss over the points: 0 for a perfect fit, 1 when all are beyond the tolerance; 0
// for no points.
double misfit(std::span<const SurfacePoint> points, const Primitive& primitive, double tolerance);

// At most `count` of the points, evenly picked in their order.
std::vector<SurfacePoint> thinned(std::span<const SurfacePoint> points, std::size_t count);

// The weight of a residual in robust least squares, Tukey's biweight: (1 - (residual /
// cutoff)^2)^2, which is 1 at residual 0, and 0 beyond the cutoff.
inline double biweight(double residual, double cutoff) {
  const double x = residual / cutoff;
  if (!(std::abs(x) < 1.0)) return 0.0;
  const double left = 1.0 - x * x;
  return left * left;
}

// The cutoff of the biweight in medians of the residuals' sizes: 4.685 standard deviations, each
// 1.48 median deviations, which is 95 % efficient for Gaussian noise.
constexpr double kCutoffMedians = 4.685 * 1.4826;

// The cutoff for the biweight, from the median size of the residuals: never below 0.4 times the
// outlier distance, nor above twice that distance or twice the median, whichever is larger.
double robust_cutoff(const Eigen::ArrayXd& residuals, const FitOptions& options);

// The weight of a point by its normal, for the part of a primitive with outward normal `n_patch_O`:
// 1, but 0.05 for a point that faces the other way. So a thin-walled object, such as a cup, is
// fitted at the outside of its wall and not between its two sides.
inline double facing_weight(const Vector3& n_O, const Vector3& n_patch_O) {
  // A normal counts as opposed from 17 degrees beyond a right angle on, so that points near edges,
  // where normals are about orthogonal to the patch, keep their full weight.
  constexpr double kOpposed = -0.3;
  constexpr double kOpposedWeight = 0.05;
  return n_O.dot(n_patch_O) < kOpposed ? kOpposedWeight : 1.0;
}

// Principal axes of the points (columns, right-handed, smallest spread first).
Matrix3 point_axes(std::span<const SurfacePoint> points);

// Principal axes of the normals' scatter, the sign of a normal ignored (columns, right-handed,
// smallest first: for a long cylinder, its axis).
Matrix3 normal_axes(std::span<const SurfacePoint> points);

}  // namespace prehend
