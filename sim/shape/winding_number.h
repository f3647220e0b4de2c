// The generalized winding number of a mesh around a point, without going through all triangles.
#pragma once

#include <array>
#include <vector>

#include "sim/base/run_context.h"
#include "sim/shape/box_tree.h"
#include "sim/shape/triangle_mesh.h"

namespace prehend {

// The boundary edges of the part of the surface below each node of a tree, for winding_number.
struct BoundaryTree {
  // `count` edges from edges[first] on; -1: none are stored, because the triangles below the node
  // are faster to go through.
  struct Boundary {
    int first = 0;
    int count = -1;
  };
  std::vector<Boundary> nodes;  // one for each node of the tree
  // Pairs of vertices, in the direction in which the part's triangle traverses the edge.
  std::vector<std::array<int, 2>> edges;
};

// `tree` is that of build_box_tree for `mesh`. O(n log n) for n triangles of a surface whose parts
// have short boundaries; for a soup of unconnected triangles nothing is stored. Throws Cancelled.
BoundaryTree build_boundary_tree(const TriangleMesh& mesh, const std::vector<BoxNode>& tree,
                                 const RunContext& context = {});

// The winding number around p_M (mesh frame): the sum of the signed solid angles of all triangles,
// divided by 4 pi (Jacobson, Kavan and Sorkine-Hornung 2013). 1 inside and 0 outside of a closed
// mesh that faces outward, and close to that where the mesh has small holes. Exact up to rounding,
// in a time about proportional to the square root of the number of triangles; the three arguments
// belong together as above.
double winding_number(const TriangleMesh& mesh, const std::vector<BoxNode>& tree,
                      const BoundaryTree& boundaries, const Vector3& p_M);

}  // namespace prehend
