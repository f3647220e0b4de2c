// The convex hull of points in space.
#pragma once

#include <vector>

#include "sim/geometry/triangle_mesh.h"

namespace prehend {

// Closed, outward-oriented mesh around all points (quickhull: Barber, Dobkin, Huhdanpaa 1996).
// Points within 1e-9 of the points' extent of a face count as inside. Empty when the points are
// flat to within 1e-6 of their extent, or not finite. Same points, same mesh.
TriangleMesh convex_hull(const std::vector<Vector3>& points);

}  // namespace prehend
