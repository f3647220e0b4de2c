// The shells of a mesh: triangles connected by shared vertices.
#pragma once

#include <vector>

#include "sim/shape/triangle_mesh.h"

namespace prehend {

struct Shell {
  Bounds box;
  double area = 0.0;  // m^2
};

// In the order of their first triangles.
struct Shells {
  std::vector<Shell> shells;
  std::vector<int> of_triangle;   // index of each triangle's shell
  double largest_diagonal = 0.0;  // of the bounds of one of them [m]
};

Shells find_shells(const TriangleMesh& mesh);

}  // namespace prehend
