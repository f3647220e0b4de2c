// A mesh from arrays of a program, made sound in the way that mesh files are.
#pragma once

#include <vector>

#include "sim/geometry/triangle_mesh.h"

namespace prehend {

// `vertices` in metres in the body's frame, `triangles` as indices into them. Vertices of no
// triangle are left out, those closer than `weld_fraction` (> 0, < 0.01) of the bounding-box
// diagonal become one, triangles without area or given twice are left out, and the surface is
// turned to face outward (orient_outward in mesh_checks.h). Holes stay. Throws InputError for an
// index out of range, a vertex that is not finite or farther out than 1e30 m, and a mesh without a
// triangle of positive area.
TriangleMesh make_mesh(std::vector<Vector3> vertices, std::vector<Triangle> triangles,
                       double weld_fraction = 1e-6);

}  // namespace prehend
