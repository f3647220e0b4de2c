// What the three fits share: their options, robust statistics, and starting directions.
#pragma once

#include <span>
#include <vector>

#include "primitives/surface_sample.h"
#include "sim/geometry/primitive.h"

namespace prehend {

struct FitOptions {
  // Distance (m, > 0) beyond which a point counts as not belonging to the primitive.
  double outlier = 0.0;
  // No extent of a primitive becomes smaller than this (m, > 0).
  double min_extent = 0.0;
  // Gauss-Newton steps from each start.
  int steps = 10;
  // Also start from directions spread over the half-sphere, for when neither the spread of the
  // points nor their normals tell the axes.
  bool thorough = true;
};

// What one step of a fit reports.
struct Step {
  double loss_before = 0.0;  // of the shape before the step: facing_weight * point_loss, summed
  double change = 0.0;       // size of the change in the unknowns
};

// The fractions of points to leave beyond each end of a starting shape: few, and (thorough) as many
// as a handle or a spout may have.
std::span<const double> starting_tails(const FitOptions& options);

// What a point at this distance from the nearest primitive surface costs: 1 beyond the tolerance,
// and within it far less, growing with the square.
double point_loss(double distance, double tolerance);

// Mean loss of the points: 0 perfect, 1 nothing explained. 0 for no points.
double misfit(std::span<const SurfacePoint> points, const Primitive& primitive, double tolerance);

// At most `count` of the points, evenly picked in their order.
std::vector<SurfacePoint> thinned(std::span<const SurfacePoint> points, std::size_t count);

// The value that a fraction `q` in [0, 1] of the values do not exceed; reorders them. Not empty.
double quantile(std::vector<double>& values, double q);

// Tukey's biweight: 1 at residual 0, 0 from `cutoff` on.
double biweight(double residual, double cutoff);

// The cutoff for the biweight, from the spread of the residuals themselves.
double robust_cutoff(std::span<const double> residuals, const FitOptions& options);

// How much a point on a patch with outward normal `n_patch` counts: a point that faces the other
// way (the inside of a cup's wall) hardly pulls, so that the fit is to the outside.
double facing_weight(const SurfacePoint& point, const Vector3& n_patch_O);

// Principal axes of the points (columns, right-handed, smallest spread first).
Matrix3 point_axes(std::span<const SurfacePoint> points);

// Principal axes of the normals' scatter, the sign of a normal ignored (columns, right-handed,
// smallest first: for a long cylinder, its axis).
Matrix3 normal_axes(std::span<const SurfacePoint> points);

// Unit directions spread evenly over a half-sphere.
std::vector<Vector3> half_sphere_directions(int count);

}  // namespace prehend
