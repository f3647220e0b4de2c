#include "planner/picture/simplified_mesh.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/geometry/weld.h"

namespace prehend {
namespace {

TriangleMesh evenly_picked(const TriangleMesh& mesh, std::size_t most) {
  TriangleMesh few{mesh.vertices, {}};
  for (std::size_t i = 0; i < most; ++i) {
    few.triangles.push_back(mesh.triangles[i * mesh.triangles.size() / most]);
  }
  drop_unused_vertices(few);
  return few;
}

}  // namespace

TriangleMesh simplified(const TriangleMesh& mesh, std::size_t most) {
  if (mesh.triangles.size() <= most) return mesh;
  TriangleMesh coarse = mesh;
  // Vertices that far apart leave somewhat more triangles than that, on any surface. Cells are
  // counted, so there cannot be any number of them in a line.
  double cell = std::max(0.5 * std::sqrt(surface_area(mesh) / static_cast<double>(most)),
                         1e-9 * bounds(mesh).diagonal());
  while (coarse.triangles.size() > most) {
    if (!(cell > 0.0)) return evenly_picked(coarse, most);
    TriangleMesh next = weld(mesh, cell).mesh;
    // Loose pieces that are smaller than what lies between them.
    if (next.triangles.empty()) return evenly_picked(coarse, most);
    coarse = std::move(next);
    const double excess = static_cast<double>(coarse.triangles.size()) / static_cast<double>(most);
    cell *= std::max(1.1, std::sqrt(excess));
  }
  return coarse;
}

}  // namespace prehend
