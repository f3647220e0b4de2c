// The patch of least area that spans a loop of edges.
#pragma once

#include <functional>
#include <vector>

#include "sim/shape/triangle_mesh.h"

namespace prehend {

// Of all triangulations of the loop without further vertices, the one of least area (Barequet and
// Sharir 1995): triangles of indices into `rim`, wound like the rim. Edges inside the patch are
// only those that `free` allows (vertices of the mesh), and no triangle is degenerate (weld.h).
// Nothing where there is no such triangulation, and for rims of more than 150 vertices. O(n^3).
std::vector<Triangle> least_patch(const TriangleMesh& mesh, const std::vector<int>& rim,
                                  const std::function<bool(int, int)>& free);

}  // namespace prehend
