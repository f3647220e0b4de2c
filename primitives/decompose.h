// From a mesh to the few boxes, spheres and cylinders that explain its surface.
#pragma once

#include <cstdint>
#include <vector>

#include "primitives/primitive.h"
#include "sim/geometry/triangle_mesh.h"

namespace prehend {

struct DecomposeOptions {
  // A surface point is explained when it lies within this fraction of the mesh's bounding-box
  // diagonal of some primitive's surface.
  double tolerance = 0.05;
  // Stop once this fraction of the area is explained.
  double coverage = 0.97;
  // At most this many primitives (>= 1).
  int max_primitives = 12;
  std::uint64_t seed = 1;
};

struct Decomposition {
  std::vector<Primitive> primitives;  // largest explained area first
  std::vector<double> share;          // per primitive, the fraction of the area that it explains
  double explained = 0.0;             // fraction of the area within tolerance of some primitive
};

// Pure function of its arguments. Throws InputError for a mesh without area.
Decomposition decompose(const TriangleMesh& mesh, const DecomposeOptions& options = {});

}  // namespace prehend
