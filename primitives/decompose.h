// Shape decomposition: approximates the surface of a mesh by a few boxes, spheres,
// cylinders and cones.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/base/run_context.h"
#include "sim/base/settings.h"
#include "sim/shape/primitive.h"
#include "sim/shape/triangle_mesh.h"

namespace prehend {

struct DecomposeOptions {
  static constexpr AboutSettings kAbout{"DecomposeOptions",
                                        "How a mesh is split into boxes, spheres, cylinders and "
                                        "cones."};
  double tolerance = 0.05;
  // Below the coverage, nearly every primitive that explains more area is added; above it, only one
  // that lowers the objective by more than its cost (region.h), such as the handle of a cup.
  double coverage = 0.97;
  int points = 3000;
  int max_primitives = 12;
  std::uint64_t seed = 1;
};

template <SettingsOf<DecomposeOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [tolerance, coverage, points, max_primitives, seed] = options;
  visit({"tolerance", "primitive_tolerance"}, tolerance, kFractionAbove0, "",
        "A point of the surface is explained when it lies within this part of the bounding box's "
        "diagonal of some primitive's surface; larger: fewer, coarser primitives.");
  visit({"coverage", "primitive_coverage"}, coverage, kFractionAbove0, "",
        "Primitives are added until this part of the area is explained.");
  visit({"points", "primitive_points"}, points, kPointCount, "",
        "Points that stand for the surface; more take longer, and what is smaller than their "
        "spacing is not seen.");
  visit("max_primitives", max_primitives, kCountAbove0, "",
        "Most primitives, also where they do not reach the coverage.");
  visit.unlisted("seed", seed, kAtLeast0, "", "Of the points on the surface.");
}

// Statistics of the distances of surface points from the primitive nearest to each [m].
struct SurfaceDistances {
  double median = 0.0;
  double percentile_95 = 0.0;
  double largest = 0.0;
};

// The primitives that approximate a mesh, in the mesh's frame.
struct Decomposition {
  std::vector<Primitive> primitives;  // sorted by the area they explain, largest first
  std::vector<double> share;          // per primitive, the fraction of the area that it explains
  double explained = 0.0;             // fraction of the area within tolerance of some primitive
  double tolerance = 0.0;             // DecomposeOptions::tolerance as a length [m]
  SurfaceDistances distances;         // of the whole surface
  // Per primitive, of the surface that is nearer to it than to the others; 0 where there is none.
  std::vector<SurfaceDistances> distances_of;
};

// DecomposeOptions::tolerance for a mesh, from a length [m]. Throws InputError for a length that is
// not above 0, or above the diagonal of the mesh's bounding box.
double relative_tolerance(const TriangleMesh& mesh, double length);

// Minimises an objective (region.h) that adds up the distances of the surface from the primitives,
// the area of the primitives that lies away from the mesh, and a cost for each primitive. First the
// surface is split again and again, by planes or into the part that one primitive explains and the
// rest, as long as that lowers the objective. Then each point is assigned to its nearest primitive,
// and primitives are refitted, merged and dropped. At last each primitive comes as close to its
// points as it gets (closest_fit.h).
//
// All this happens in the object's own frame (own_frame.h), whose box is the bounding box that
// options speak of, and uses about a fixed number of points that depend on the surface only. So
// primitives turn, move and scale with the object, whatever triangles it is divided into; the time
// hardly depends on their number, and the mesh need not be closed or oriented. The explained
// fractions and the distances are estimates from those points.
//
// The same arguments give the same result, on any number of threads. Throws InputError for a mesh
// without area, with an index out of range or a vertex that is not finite, and for an option out of
// its range; throws Cancelled.
Decomposition decompose(const TriangleMesh& mesh, const DecomposeOptions& options = {},
                        const RunContext& context = {});

}  // namespace prehend
