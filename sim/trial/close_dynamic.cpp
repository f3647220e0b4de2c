#include "sim/trial/close_dynamic.h"

#include <algorithm>

#include "sim/motion/dynamic_grasp/form_dynamic_grasp.h"
#include "sim/motion/step_options.h"
#include "sim/shape/smooth_surface.h"
#include "sim/trial/payload_margin.h"

namespace prehend {
namespace {

// What a trial says of an object that is not in the hand at the end.
std::optional<Outcome> lost_as(ObjectEnd end) {
  switch (end) {
    case ObjectEnd::held:
    case ObjectEnd::touching:
      return std::nullopt;
    case ObjectEnd::untouched:
      return Outcome::no_contact;
    case ObjectEnd::pushed_away:
      return Outcome::pushed_away;
    case ObjectEnd::toppled:
      return Outcome::toppled;
    case ObjectEnd::squeezed_out:
      return Outcome::squeezed_out;
    case ObjectEnd::dropped:
      return Outcome::dropped;
  }
  return std::nullopt;
}

bool failed(const DynamicGrasp& formation) {
  return formation.last == StepOutcome::blocked || formation.last == StepOutcome::not_finite;
}

// Surfaces that rest on each other in a world keep a gap, and smooth ones are a little away from
// their meshes: contacts at the end are within this of each other, too.
TrialOptions judging(const TrialOptions& options) {
  TrialOptions judging = options;
  judging.contact.threshold =
      std::max(options.contact.threshold, StepOptions{}.rest_gap + 2.0 * kMostSag);
  return judging;
}

}  // namespace

void close_dynamic(const CompiledScene& scene, const std::shared_ptr<const RobotModel>& hand,
                   const ClosingStart& start, const TrialOptions& options,
                   GraspWorkspace& workspace, Trial& trial, const RunContext& context) {
  const std::vector<double> joints =
      start.joints.empty() ? joint_values(scene.scene.hand, start.dofs) : start.joints;
  trial.contacts.clear();
  trial.epsilon = {};
  trial.blocked = hand_collision(scene, start.X_OH, joints, workspace.collision);
  if (trial.blocked) {
    trial.outcome = Outcome::hand_blocked;
    return;
  }
  const Pose& X_WO = scene.scene.object.X_WO;
  const DynamicGraspStart from{X_WO * start.X_OH, start.dofs, start.joints, start.strategy,
                               start.farthest};
  const DynamicGrasp formation = form_dynamic_grasp(scene, hand, from, options.formation, context);
  trial.X_OC = X_WO.inverse() * formation.X_WO;
  trial.X_OH = formation.X_WO.inverse() * formation.X_WH;
  trial.dofs = formation.dofs;
  trial.joints = formation.joints;
  const std::optional<Outcome> lost = lost_as(formation.end);
  if (failed(formation)) {
    trial.outcome = Outcome::not_simulated;
  } else if (lost && lost != Outcome::dropped) {
    trial.outcome = *lost;
  } else {
    score_contacts(scene, judging(options), workspace.scoring, trial);
    if (lost) trial.outcome = *lost;
  }
}

Trial closed_freely(const CompiledScene& scene, const std::shared_ptr<const RobotModel>& hand,
                    const Candidate& candidate, const Trial& trial, const TrialOptions& options,
                    const RunContext& context, double farthest) {
  const double left = candidate.approach_distance - trial.travel;
  ClosingStart start;
  start.X_OH = translation(trial.overlap_shift - left * candidate.approach_O) * candidate.X_OH;
  start.dofs = start_dofs(scene.scene.hand, candidate);
  start.joints = candidate.joints;
  start.strategy = strategy_of(scene.scene.hand, candidate);
  start.farthest = farthest;
  Trial free = trial;
  GraspWorkspace workspace;
  close_dynamic(scene, hand, start, options, workspace, free, context);
  return free;
}

bool keeps_object(const CompiledScene& scene, const Trial& free) {
  return free.outcome == Outcome::stable ||
         (free.outcome == Outcome::not_force_closure && scene.has_obstacles());
}

double object_moved(const CompiledScene& scene, const Trial& free) {
  const Vector3& center_O = scene.wrench_frame.torque_origin;
  return free.X_OC ? (*free.X_OC * center_O - center_O).norm() : 0.0;
}

std::optional<FreeEnd> free_end(const CompiledScene& scene, const Trial& free) {
  if (!free.X_OC || free.outcome == Outcome::not_simulated) return std::nullopt;
  FreeEnd end;
  end.kept = keeps_object(scene, free);
  if (end.kept) {
    end.epsilon = free.epsilon.lower;
    end.strength = weight_strength(scene, free);
  }
  end.moved = object_moved(scene, free);
  return end;
}

}  // namespace prehend
