// Convex sets around a surface, for quick separation tests.
#pragma once

#include <vector>

#include "sim/shape/separation.h"
#include "sim/shape/triangle_mesh.h"

namespace prehend {

// Convex sets whose union contains the surface: one around each connected component, or a single
// one when there are many components. Hulls of many corners are replaced by coarser sets around
// them (ConvexPoints::margin).
std::vector<ConvexPoints> convex_parts(const TriangleMesh& mesh);

// A set of at most `most` points, grown by a margin so that it contains all points of the hull,
// which is a mesh from convex_hull. Elongated hulls are covered as evenly as round ones.
ConvexPoints coarse_hull(const TriangleMesh& hull, int most);

}  // namespace prehend
