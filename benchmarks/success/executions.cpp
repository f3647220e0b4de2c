#include "benchmarks/success/executions.h"

#include <memory>
#include <utility>

#include "sim/base/parallel/parallel.h"
#include "sim/manipulation/shake.h"
#include "sim/motion/dynamic_grasp/scene_world.h"
#include "sim/scene/compiled_scene.h"
#include "sim/trial/close_dynamic.h"
#include "sim/trial/perturbed_trials.h"
#include "sim/trial/run_trial.h"

namespace prehend::bench {
namespace {

// The hand closes, rises by 10 cm and shakes what it holds as ACRONYM does (Eppner et al. 2021),
// but with its weight: along the approach with up to 6.3 m/s^2 and 2 Hz, then about the axis on
// which the fingers close. The object may move in the hand by 3 cm.
TestProcedure lift_and_shake(double friction) {
  const Vector3 gravity(0.0, 0.0, -9.81);
  ProcedurePhase lift{.kind = PhaseKind::lift, .duration = 0.5, .gravity = gravity, .height = 0.1};
  ProcedurePhase swing{.kind = PhaseKind::swing,
                       .duration = 0.5,
                       .gravity = gravity,
                       .frame = ProcedureFrame::hand,
                       .axis = Vector3::UnitZ(),
                       .amplitude = 0.04,
                       .frequency = 2.0};
  ProcedurePhase turn = swing;
  turn.kind = PhaseKind::turn;
  turn.axis = Vector3::UnitX();
  turn.amplitude = 0.5;
  for (ProcedurePhase* phase : {&lift, &swing, &turn}) {
    phase->fails = {.moved = 0.03, .loses_contact = true};
  }
  TestProcedure procedure;
  procedure.name = "lift and shake";
  procedure.step = 4e-3;
  procedure.friction = friction;
  procedure.prepare = {{.kind = PhaseKind::close, .duration = 0.6}};
  procedure.tests = {{"lift and shake", {lift, swing, turn}}};
  return procedure;
}

// Friction of the hand on the object: the mean of the contacts.
double friction_of(const Trial& trial) {
  double sum = 0.0;
  for (const GraspContact& contact : trial.contacts) sum += contact.point.friction;
  return sum / static_cast<double>(trial.contacts.size());
}

// The scene as it is for one disturbance, with its hand.
struct Disturbed {
  CompiledScene scene;
  std::shared_ptr<const RobotModel> hand;
};

Disturbed disturbed(const CompiledScene& scene, const Perturbation& perturbation) {
  Scene changed = scene.scene;
  changed.object.center_of_mass += perturbation.center_of_mass_O;
  for (const Material a : kAll<Material>) {
    for (const Material b : kAll<Material>) {
      changed.friction.set(a, b, perturbation.friction * scene.scene.friction.between(a, b));
    }
  }
  CompiledScene compiled = compile(std::move(changed));
  std::shared_ptr<const RobotModel> hand = hand_model(compiled);
  return {std::move(compiled), std::move(hand)};
}

bool lifts(const Disturbed& now, const ScoredGrasp& grasp, const TrialOptions& options,
           const Perturbation& perturbation) {
  TrialOptions once = options;
  once.back_off_tries = 0;
  TrialWorkspace workspace;
  Trial trial;
  const Candidate motion = replayed_approach(grasp.candidate, grasp.trial, perturbation.X_OC);
  run_hand_trial(now.scene, motion, once, workspace, trial, {});
  if (is_blocked(trial.outcome)) return false;
  const Trial free = closed_freely(now.scene, now.hand, motion, trial, once);
  if (!keeps_object(now.scene, free)) return false;
  const TestProcedure procedure = lift_and_shake(friction_of(free));
  return shake_grasp(now.scene, now.hand, posture_of(free), procedure).holds();
}

}  // namespace

std::vector<Executions> execute_grasps(const CompiledScene& scene, const TrialOptions& options,
                                       const std::vector<Perturbation>& perturbations,
                                       const PlanResult& result) {
  std::vector<Executions> executions(result.grasps.size());
  for (const Perturbation& perturbation : perturbations) {
    const Disturbed now = disturbed(scene, perturbation);
    for_each_in_parallel(result.grasps.size(), 0, [&](std::size_t i) {
      ++executions[i].tried;
      executions[i].lifted += lifts(now, result.grasps[i], options, perturbation) ? 1 : 0;
    });
  }
  return executions;
}

}  // namespace prehend::bench
