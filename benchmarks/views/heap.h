// Things that fell on each other on a table, and what cameras see of them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/shape/cloud/depth_view.h"
#include "sim/shape/triangle_mesh.h"

namespace prehend::bench {

struct HeapThing {
  std::string name;
  TriangleMesh mesh_W;  // where it came to rest
};

// One thing of each mesh file (in metres), dropped one after the other, turned at random, near the
// origin of the table z = 0, in a frame that keeps them together and is then gone (step_world). A
// thing that leaves the frame is dropped again. Throws std::runtime_error where one does not stay
// at ten attempts.
std::vector<HeapThing> fallen_heap(const std::vector<std::string>& files, std::uint64_t seed);

// The views of `count` cameras around the heap, 0.7 m away, 45 degrees down.
std::vector<DepthView> views_of_heap(const std::vector<HeapThing>& heap, int count,
                                     std::uint64_t seed);

}  // namespace prehend::bench
