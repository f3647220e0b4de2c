// The convex hull of points in space.
#pragma once

#include <vector>

#include "sim/shape/triangle_mesh.h"

namespace prehend {

// The convex hull as a closed mesh with outward-facing triangles (quickhull: Barber, Dobkin and
// Huhdanpaa 1996). A point that is less than 1e-9 of the extent of the set above a face counts as
// inside. Returns an empty mesh for fewer than four points, for points within 1e-6 of their extent
// of a plane, and when a point is not finite. Equal points give equal meshes.
TriangleMesh convex_hull(const std::vector<Vector3>& points);

}  // namespace prehend
