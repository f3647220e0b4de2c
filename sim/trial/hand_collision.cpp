#include "sim/trial/hand_collision.h"

#include <algorithm>

namespace prehend {

std::optional<HandContact> hand_collision(const CompiledScene& scene, const Pose& X_OH,
                                          const std::vector<double>& joints,
                                          HandCollisionWorkspace& workspace) {
  robot_poses(scene.scene.hand, joints, workspace.poses);
  return hand_collision(scene, X_OH, workspace.poses, CollisionScope::all, workspace.near);
}

std::optional<HandContact> hand_collision(const CompiledScene& scene, const Pose& X_OH,
                                          const RobotPoses& poses, CollisionScope among,
                                          NearBodies& near) {
  const std::vector<BodyId>& found = near.found;
  for (std::size_t l = 0; l < scene.links.size(); ++l) {
    const CompiledLink& link = scene.links[l];
    const Pose X_OL = X_OH * poses.X_BL[l];
    const auto overlaps = [&](BodyId body) {
      return bodies_overlap(scene.body(body), link, scene.pose_in(body, X_OL));
    };
    if (among != CollisionScope::obstacles && overlaps(BodyId::object())) {
      return HandContact{link_id(l), BodyId::object()};
    }
    if (among == CollisionScope::object) continue;
    const Vector3 center_O = X_OL * link.mesh.ball_center();
    scene.near_obstacles.find({center_O, center_O, link.mesh.ball_radius()}, near);
    const auto hit = std::find_if(found.begin(), found.end(), overlaps);
    if (hit != found.end()) return HandContact{link_id(l), *hit};
  }
  return std::nullopt;
}

}  // namespace prehend
