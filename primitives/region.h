// A piece of the surface, the primitive that fits it best, and what that choice costs.
#pragma once

#include <span>
#include <vector>

#include "primitives/near_surface.h"
#include "primitives/surface_sample.h"
#include "sim/base/run_context.h"
#include "sim/geometry/primitive.h"

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
  double tolerance = 0.0;
  double coverage = 0.0;
  Cancellation cancellation;  // checked by every fit
};

// The cost of each primitive: one more must lower the rest of the objective by at least this.
constexpr double kPieceCost = 0.015;

// While less than the coverage is explained, a primitive pays for itself (kPieceCost) as soon as it
// explains another 0.75 % of the surface.
constexpr double kShortfallCost = 2.0;

// A part of the surface and its primitive.
struct Region {
  std::vector<SurfacePoint> points;
  Primitive primitive;       // the best fit to the points
  double cost = 0.0;         // its share of the objective, without the piece and the shortfall
  double unexplained = 0.0;  // share of the whole surface: points of it beyond the tolerance
};

enum class Effort {
  quick,     // few points, few starts: to compare many candidates
  thorough,  // all points
};

// The box, sphere or cylinder of least cost for these points (at least one). Throws Cancelled.
Region fit_region(std::vector<SurfacePoint> points, const Surface& surface, Effort effort);

// The region with a thorough fit to all its points. It keeps its own primitive where the new one
// costs more.
Region refitted(Region region, const Surface& surface);

// The phantom term of the objective for one primitive: how much of its surface lies where the mesh
// has none. Without this term a large primitive that merely touches the points would cost nothing.
double phantom_cost(const Primitive& primitive, const Surface& surface);

// The distance (>= 0) of each of surface.points from the primitive's surface.
std::vector<double> distances(const Primitive& primitive, const Surface& surface);

}  // namespace prehend
