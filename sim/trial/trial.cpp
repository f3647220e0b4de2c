#include "sim/trial/trial.h"

#include "sim/base/index.h"
#include "sim/scene/compiled_scene.h"

namespace prehend {

Pose hand_in_scene(const Trial& trial) {
  return trial.X_OC ? *trial.X_OC * trial.X_OH : trial.X_OH;
}

CollisionNames collision_of(const CompiledScene& scene, const Trial& trial) {
  if (trial.arm_pair) {
    return {first_name(*scene.arm, *trial.arm_pair), second_name(*scene.arm, *trial.arm_pair)};
  }
  if (!trial.blocked) return {};
  return {scene.links[index(trial.blocked->link)].name, scene.body(trial.blocked->body).name};
}

}  // namespace prehend
