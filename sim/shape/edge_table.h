// The edges of a mesh and the triangles that meet at each of them.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "sim/shape/triangle_mesh.h"

namespace prehend {

// One of the three sides of a triangle. The edge joins vertices `low` < `high`; `forward` tells
// whether the triangle, in its winding order, traverses it from `low` to `high`. At a consistently
// wound manifold edge one triangle traverses it forward, the other backward.
struct EdgeUse {
  int low = 0;
  int high = 0;
  int triangle = 0;
  bool forward = true;
};

// The sides of all triangles with three distinct vertices, sorted by (low, high, triangle), so that
// the uses of one edge are consecutive.
std::vector<EdgeUse> edge_uses(const TriangleMesh& mesh);

// Calls visit(std::span<const EdgeUse>) once for each edge with all its uses, in sorted order.
// `uses` comes from edge_uses.
template <typename Visit>
void for_each_edge(const std::vector<EdgeUse>& uses, Visit visit) {
  for (std::size_t first = 0; first < uses.size();) {
    std::size_t last = first + 1;
    while (last < uses.size() && uses[last].low == uses[first].low &&
           uses[last].high == uses[first].high) {
      ++last;
    }
    visit(std::span<const EdgeUse>(uses.data() + first, last - first));
    first = last;
  }
}

// Number of forward uses minus number of backward uses of one edge. 0 at every edge means that the
// surface is the boundary of a solid in the sense of signed volume.
int net_direction(std::span<const EdgeUse> edge);

}  // namespace prehend
