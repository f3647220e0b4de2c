#include "sim/trial/swallow.h"

#include <algorithm>

namespace prehend {
namespace {

bool any_inside(const ProximityMesh& mesh, const std::vector<Vector3>& points, const Pose& X) {
  return std::any_of(points.begin(), points.end(),
                     [&](const Vector3& p) { return is_inside(mesh, X * p); });
}

}  // namespace

bool is_swallowed(const CompiledScene& scene, const CompiledLink& link, int obstacle,
                  const Pose& X_BL) {
  const CompiledObstacle* other =
      obstacle < 0 ? nullptr : &scene.obstacles[static_cast<std::size_t>(obstacle)];
  const ProximityMesh& body = other ? other->mesh : scene.object;
  const double apart = (X_BL * link.mesh.ball_center() - body.ball_center()).norm();
  if (apart > body.ball_radius() + link.mesh.ball_radius()) return false;
  const bool is_solid = other ? other->is_solid : scene.object_is_solid;
  if (is_solid && any_inside(body, link.probes, X_BL)) return true;
  return any_inside(link.mesh, other ? other->probes : scene.object_probes, X_BL.inverse());
}

}  // namespace prehend
