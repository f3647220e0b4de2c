#include "sim/scene/carried_object.h"

#include <algorithm>
#include <utility>

#include "sim/base/index.h"

namespace prehend {
namespace {

bool is_with_object(const ArmPair& pair) {
  const BodyId* body = std::get_if<BodyId>(&pair.other);
  return body != nullptr && body->is_object();
}

}  // namespace

CompiledArm arm_with_object(const CompiledScene& scene, const Pose& X_OH) {
  CompiledArm arm = *scene.arm;
  std::erase_if(arm.arm_pairs, is_with_object);
  std::erase_if(arm.hand_pairs, is_with_object);
  const PlatformPart& hand = arm.hand_part();
  const GraspableBody& object = scene.scene.object;
  Link link{.name = object.name,
            .material = "plastic",  // friction with itself is nobody's business
            .joint = hand.joint,
            .mesh = object.mesh};
  const Pose X_JO = hand.X_JR * X_OH.inverse();
  for (Vector3& p : link.mesh.vertices) p = X_JO * p;
  CompiledLink carried = compile_link(scene.scene, arm.robot(), link);
  carried.is_solid = scene.object().is_solid;
  arm.platform.robot.links.push_back(std::move(link));
  arm.links.push_back(std::move(carried));
  const LinkId id = carried_object(arm);
  for (std::size_t l = 0; l + 1 < arm.links.size(); ++l) {
    // What is fixed to the same frame as the hand's base never moves against the object.
    if (arm.is_hand_link(link_id(l)) || arm.robot().links[l].joint == hand.joint) continue;
    arm.arm_pairs.push_back(arm_pair(arm, id, link_id(l)));
  }
  for (std::size_t b = 1; b < arm.bodies.size(); ++b) {
    arm.arm_pairs.push_back(arm_pair(arm, id, BodyId::at(b)));
  }
  return arm;
}

LinkId carried_object(const CompiledArm& arm) { return link_id(arm.links.size() - 1); }

}  // namespace prehend
