#include "sim/scene/seen_surface.h"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "sim/shape/nearest_point.h"
#include "sim/shape/proximity.h"

namespace prehend {
namespace {

double distance_to(const TriangleMesh& mesh, const Triangle& triangle, const Vector3& p) {
  std::array<Vector3, 3> corners;
  for (std::size_t k = 0; k < 3; ++k) corners[k] = mesh.vertices[index(triangle[k])];
  return (nearest_point_on(corners, p) - p).norm();
}

}  // namespace

std::optional<bool> is_seen_at(const CompiledScene& scene, const Vector3& p_O) {
  const std::optional<Completion>& completion = scene.scene.object.completion;
  if (!completion) return {};
  const ProximityMesh& surface = scene.object().mesh;
  const TriangleMesh& mesh = surface.mesh();
  std::vector<int> near;
  // Contacts are within a fraction of a millimetre of the surface.
  for (double reach = 1e-3; near.empty() && reach < surface.ball_radius(); reach *= 4.0) {
    find_triangles_in(surface, {p_O.array() - reach, p_O.array() + reach}, near);
  }
  std::sort(near.begin(), near.end());
  double least = std::numeric_limits<double>::infinity();
  bool seen = false;
  for (const int t : near) {
    const double distance = distance_to(mesh, mesh.triangles[index(t)], p_O);
    if (distance >= least) continue;
    least = distance;
    seen = completion->seen[index(t)] != 0;
  }
  return seen;
}

}  // namespace prehend
