#include "planner/show/posed_grasp.h"

#include "planner/plan/path/grasp_motion.h"
#include "planner/plan/plan_result.h"
#include "sim/scene/compiled_scene.h"

namespace prehend {

PosedGrasp posed_grasp(const CompiledScene& scene, const ScoredGrasp& grasp,
                       const std::string& title) {
  const Trial& trial = grasp.trial;
  PosedGrasp posed{hand_in_scene(trial), trial.joints, trial.contacts, trial.epsilon.weakest,
                   title};
  posed.X_OC = trial.X_OC.value_or(Pose::Identity());
  if (scene.arm && !trial.arm_dofs.empty()) {
    posed.arm_joints = arm_joints(*scene.arm, trial.arm_dofs, trial.joints);
  }
  return posed;
}

PosedGrasp posed_at(const MotionFrame& frame) {
  return {frame.X_OH, frame.joints, {}, Wrench::Zero(), "", frame.arm_joints, frame.X_OC};
}

}  // namespace prehend
