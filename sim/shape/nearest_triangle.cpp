#include "sim/shape/nearest_triangle.h"

#include <algorithm>
#include <cstddef>

#include "sim/shape/nearest_point.h"
#include "sim/shape/proximity.h"

namespace prehend {

// Boxes around the point grow until one holds the nearest triangle and all that are hardly farther.
// Most points asked for lie on the surface, so that the first box is enough.
void nearest_triangles(const ProximityMesh& mesh, const Vector3& p_M, double margin,
                       std::vector<int>& triangles) {
  constexpr double kGrowth = 4.0;
  std::vector<double> distances;
  for (double reach = 2.0 * margin;; reach *= kGrowth) {
    const Bounds around{p_M - Vector3::Constant(reach), p_M + Vector3::Constant(reach)};
    find_triangles_in(mesh, around, triangles);
    if (triangles.empty()) continue;
    std::sort(triangles.begin(), triangles.end());
    distances.clear();
    for (const int t : triangles) {
      distances.push_back((nearest_point_on(corners_of(mesh.mesh(), t), p_M) - p_M).norm());
    }
    const double most = *std::min_element(distances.begin(), distances.end()) + margin;
    if (most > reach) continue;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      if (distances[i] <= most) triangles[kept++] = triangles[i];
    }
    triangles.resize(kept);
    return;
  }
}

}  // namespace prehend
