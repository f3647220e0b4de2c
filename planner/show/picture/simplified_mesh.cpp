#include "planner/show/picture/simplified_mesh.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/shape/weld.h"

namespace prehend {
namespace {

// Every n-th triangle: the last resort for meshes that clustering would make vanish.
TriangleMesh evenly_picked(const TriangleMesh& mesh, std::size_t most) {
  TriangleMesh few{mesh.vertices, {}};
  for (std::size_t i = 0; i < most; ++i) {
    few.triangles.push_back(mesh.triangles[i * mesh.triangles.size() / most]);
  }
  drop_unused_vertices(few);
  return few;
}

}  // namespace

// Vertex clustering: vertices within a cell size of each other are merged, and triangles that lose
// their area thereby disappear. Which cell size leaves the wanted number of triangles is found by
// trying larger ones.
TriangleMesh simplified(const TriangleMesh& mesh, std::size_t most) {
  if (mesh.triangles.size() <= most) return mesh;
  TriangleMesh coarse = mesh;
  // Vertices this far apart leave somewhat more than `most` triangles on any surface, so the search
  // starts too fine and coarsens. The lower bound keeps the integer cell indices of the clustering
  // from overflowing.
  double cell = std::max(0.5 * std::sqrt(surface_area(mesh) / static_cast<double>(most)),
                         1e-9 * bounds(mesh).diagonal());
  while (coarse.triangles.size() > most) {
    if (!(cell > 0.0)) return evenly_picked(coarse, most);
    TriangleMesh next = weld(mesh, cell).mesh;
    // Every triangle has collapsed: the mesh has loose pieces smaller than the gaps between them.
    if (next.triangles.empty()) return evenly_picked(coarse, most);
    coarse = std::move(next);
    // The number of triangles falls with the square of the cell size.
    const double excess = static_cast<double>(coarse.triangles.size()) / static_cast<double>(most);
    // At least 10 % larger in each round, so that the loop ends.
    cell *= std::max(1.1, std::sqrt(excess));
  }
  return coarse;
}

}  // namespace prehend
