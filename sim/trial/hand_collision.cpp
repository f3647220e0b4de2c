#include "sim/trial/hand_collision.h"

#include <algorithm>

namespace prehend {

std::optional<HandContact> hand_collision(const CompiledScene& scene, const Pose& X_OH,
                                          const std::vector<double>& joints,
                                          HandCollisionWorkspace& workspace) {
  robot_poses(scene.scene.hand, joints, workspace.poses);
  const std::vector<BodyId>& near = workspace.near.found;
  for (std::size_t l = 0; l < scene.links.size(); ++l) {
    const CompiledLink& link = scene.links[l];
    const Pose X_OL = X_OH * workspace.poses.X_BL[l];
    const auto overlaps = [&](BodyId body) {
      return bodies_overlap(scene.body(body), link, scene.pose_in(body, X_OL));
    };
    if (overlaps(BodyId::object())) return HandContact{link_id(l), BodyId::object()};
    const Vector3 center_O = X_OL * link.mesh.ball_center();
    scene.near_obstacles.find({center_O, center_O, link.mesh.ball_radius()}, workspace.near);
    const auto found = std::find_if(near.begin(), near.end(), overlaps);
    if (found != near.end()) return HandContact{link_id(l), *found};
  }
  return std::nullopt;
}

}  // namespace prehend
