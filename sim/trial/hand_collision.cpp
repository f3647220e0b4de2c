#include "sim/trial/hand_collision.h"

namespace prehend {

std::optional<HandContact> hand_collision(const CompiledScene& scene, const Pose& X_OH,
                                          const std::vector<double>& joints) {
  std::vector<Pose> X_HL;
  link_poses(scene.scene.hand, joints, X_HL);
  for (std::size_t l = 0; l < scene.links.size(); ++l) {
    const Pose X_OL = X_OH * X_HL[l];
    for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
      const BodyId body = BodyId::at(b);
      if (bodies_overlap(scene.body(body), scene.links[l], scene.pose_in(body, X_OL))) {
        return HandContact{link_id(l), body};
      }
    }
  }
  return std::nullopt;
}

}  // namespace prehend
