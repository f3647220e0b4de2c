// The edges of a mesh and the triangles at each of them.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "sim/geometry/triangle_mesh.h"

namespace prehend {

// One side of a triangle. `forward`: the triangle runs from `low` to `high`, the smaller to the
// greater vertex index.
struct EdgeUse {
  int low = 0;
  int high = 0;
  int triangle = 0;
  bool forward = true;
};

// All sides of all triangles with three distinct vertices, sorted by (low, high, triangle): the
// uses of an edge are neighbours.
std::vector<EdgeUse> edge_uses(const TriangleMesh& mesh);

// Calls visit(std::span<const EdgeUse>) once for each edge, in order.
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

// How often the edge is run through forward less how often backward; 0 where surfaces close up.
int net_direction(std::span<const EdgeUse> edge);

}  // namespace prehend
