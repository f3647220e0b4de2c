// From a mesh to the few boxes, spheres and cylinders that explain its surface.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/base/run_context.h"
#include "sim/base/settings.h"
#include "sim/geometry/primitive.h"
#include "sim/geometry/triangle_mesh.h"

namespace prehend {

struct DecomposeOptions {
  // A surface point is explained when it lies within this fraction of the mesh's bounding-box
  // diagonal of some primitive's surface; in (0, 1].
  double tolerance = 0.05;
  // Pieces are added until this fraction of the area is explained, in (0, 1]. Short of it nearly
  // any piece that explains more is taken; beyond it only one that pays for itself (a handle does).
  double coverage = 0.97;
  // At most this many primitives (>= 1). Wins over coverage.
  int max_primitives = 12;
  std::uint64_t seed = 1;
};

template <SettingsOf<DecomposeOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [tolerance, coverage, max_primitives, seed] = options;
  visit("primitive_tolerance", tolerance);
  visit("primitive_coverage", coverage);
  visit("max_primitives", max_primitives);
}

struct Decomposition {
  std::vector<Primitive> primitives;  // largest explained area first
  std::vector<double> share;          // per primitive, the fraction of the area that it explains
  double explained = 0.0;             // fraction of the area within tolerance of some primitive
};

// Splits the surface by planes, or into what one primitive explains and the rest, for as long as
// that lowers an objective (primitives/region.h) that weighs the distance from surface to
// primitives, the primitives' surface that is far from the mesh, and their number; then gives each
// point to its nearest primitive, refits, merges and drops. Works on a fixed number of points
// spread by area, so its time hardly depends on the number of triangles; orientation and closedness
// of the mesh do not matter. Explained fractions are estimates from those points. Pure function of
// its arguments. Throws InputError for a mesh without area, with an index or a vertex that cannot
// be used, or for an option out of its range; Cancelled.
Decomposition decompose(const TriangleMesh& mesh, const DecomposeOptions& options = {},
                        const RunContext& context = {});

}  // namespace prehend
