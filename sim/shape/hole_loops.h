// The rims of the holes of a mesh.
#pragma once

#include <vector>

#include "sim/shape/triangle_mesh.h"

namespace prehend {

// A closed chain of boundary edges (edges of exactly one triangle).
struct HoleLoop {
  // In the order in which a patch that is wound like the surface around it has them; none twice.
  std::vector<int> vertices;
  int triangle = 0;  // one that has an edge on the rim
};

// All of them, in the order of the first edge of each. A chain that meets itself at a vertex is
// several loops. Left out are chains that come to an edge of three or more triangles, or to
// triangles that are wound against each other. O(n log n) for n triangles.
std::vector<HoleLoop> hole_loops(const TriangleMesh& mesh);

}  // namespace prehend
