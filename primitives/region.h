// A piece of the surface, the primitive that fits it best, and what that choice costs.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "primitives/near_surface.h"
#include "primitives/surface_sample.h"
#include "sim/base/run_context.h"
#include "sim/shape/primitive.h"

namespace prehend {

// The sampled object, in a frame where its bounding box is about one unit long, and what a
// decomposition of it must explain. The objective that a decomposition minimises is the sum of
//   the mean over all points of point_loss(distance to the nearest primitive's surface),
//   0.6 * (area of the primitives' surfaces far from any mesh surface) / (the mesh's area),
//   kPieceCost for each primitive, and
//   kShortfallCost * (share of the points that is missing from the coverage asked for).
struct Surface {
  std::vector<SurfacePoint> points;
  NearSurface near;
  double area = 0.0;
  std::size_t whole = 0;  // number of points of the whole surface: `points` may be a part of it
  double tolerance = 0.0;
  double coverage = 0.0;
  int threads = 0;            // as in RunContext
  Cancellation cancellation;  // checked by every fit
};

// The cost of each primitive: one more must lower the rest of the objective by at least this.
constexpr double kPieceCost = 0.015;

// While less than the coverage is explained, a primitive pays for itself (kPieceCost) as soon as it
// explains another 0.75 % of the surface.
constexpr double kShortfallCost = 2.0;

// A primitive and what it costs for the points that it was fitted to: its share of the objective,
// without the piece and the shortfall.
struct Fit {
  Primitive primitive;
  double cost = std::numeric_limits<double>::infinity();
};

// A part of the surface and the best fit to its points.
struct Region {
  std::vector<SurfacePoint> points;
  Fit fit;
  double unexplained = 0.0;  // share of the whole surface: points of it beyond the tolerance
  bool shares_axis = false;  // with other regions: better known than from its points
};

// So many points are enough for a quick fit.
constexpr std::size_t kQuickPoints = 160;

// The box, sphere or cylinder of least cost for these points (at least one), which stand for
// `share` of the surface. Quick: it starts from few directions and takes few steps, to compare many
// candidates. Throws Cancelled.
Fit quick_fit(std::span<const SurfacePoint> points, double share, const Surface& surface);

// A region for each part (of at least one point), with the thorough fit to all its points. The same
// on any number of threads. Throws Cancelled.
std::vector<Region> fit_regions(std::vector<std::vector<SurfacePoint>> parts,
                                const Surface& surface);

// Fits as by fit_regions, but each part keeps the fit it comes with where the new one costs more.
std::vector<Region> refitted(std::vector<std::vector<SurfacePoint>> parts,
                             const std::vector<Primitive>& primitives, const Surface& surface);

// The phantom term of the objective for one primitive: how much of its surface lies where the mesh
// has none. Without this term a large primitive that merely touches the points would cost nothing.
double phantom_cost(const Primitive& primitive, const Surface& surface);

// The share of the whole surface that `count` of its points stand for.
double share_of(std::size_t count, const Surface& surface);

// The points of the surface by the primitive that is nearest to each, of equally near ones the
// first: those of region k at place k, which may be none.
std::vector<std::vector<SurfacePoint>> points_by_nearest(const std::vector<Region>& regions,
                                                         const Surface& surface);

// The distance (>= 0) of each of the points from the primitive's surface.
std::vector<double> distances(const Primitive& primitive, std::span<const SurfacePoint> points);

}  // namespace prehend
