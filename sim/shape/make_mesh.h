// Makes a cleaned mesh from arrays, in the way in which mesh files are cleaned.
#pragma once

#include <vector>

#include "sim/shape/triangle_mesh.h"

namespace prehend {

// `vertices` [m] are in the body's frame; `triangles` are indices into them.
// - Vertices that no triangle uses are removed.
// - Vertices closer than `weld_fraction` (> 0, < 0.01) of the bounding-box diagonal are merged.
// - Triangles without area and duplicates are removed (weld.h).
// - Triangles are turned to face outward (orient_outward in mesh_checks.h).
// Holes are kept. Throws InputError for an index out of range, a vertex that is not finite or has a
// coordinate beyond 1e6 m, and a mesh without a triangle of positive area.
TriangleMesh make_mesh(std::vector<Vector3> vertices, std::vector<Triangle> triangles,
                       double weld_fraction = 1e-6);

}  // namespace prehend
