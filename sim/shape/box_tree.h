// Bounding-volume hierarchy of axis-aligned boxes over the triangles of a mesh.
#pragma once

#include <vector>

#include "sim/base/run_context.h"
#include "sim/shape/triangle_mesh.h"

namespace prehend {

// The box |p - center| <= half, component by component, in the frame of the mesh [m].
struct BoxNode {
  Vector3 center = Vector3::Zero();
  Vector3 half = Vector3::Zero();
  int left = -1;      // index of the first child, the second follows it; -1: a leaf
  int triangle = -1;  // the only triangle of a leaf

  bool is_leaf() const { return left < 0; }
};

// Builds the tree, one triangle per leaf; node 0 is the root. A node is split where the surface
// areas of both boxes, times their numbers of triangles, add up to the least (the surface area
// heuristic; Goldsmith and Salmon 1987, in bins as by Wald 2007). At most about 50 + log2 of the
// number of triangles deep. Empty for an empty mesh. Throws Cancelled.
std::vector<BoxNode> build_box_tree(const TriangleMesh& mesh, const RunContext& context = {});

}  // namespace prehend
