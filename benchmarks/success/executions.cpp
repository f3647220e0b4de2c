#include "benchmarks/success/executions.h"

#include <memory>

#include "sim/base/parallel/parallel.h"
#include "sim/manipulation/shake.h"
#include "sim/scene/compiled_scene.h"
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

bool lifts(const CompiledScene& scene, const std::shared_ptr<const RobotModel>& hand,
           const ScoredGrasp& grasp, const TrialOptions& options,
           const Perturbation& perturbation) {
  TrialOptions once = options;
  once.back_off_tries = 0;
  TrialWorkspace workspace;
  Trial trial;
  run_hand_trial(scene, replayed_approach(grasp.candidate, grasp.trial, perturbation.X_OC), once,
                 workspace, trial, {});
  if (trial.contacts.empty()) return false;
  const TestProcedure procedure = lift_and_shake(friction_of(trial) * perturbation.friction);
  return shake_grasp(scene, hand, posture_of(trial), procedure).holds();
}

}  // namespace

std::vector<Executions> execute_grasps(const CompiledScene& scene, const TrialOptions& options,
                                       const std::vector<Perturbation>& perturbations,
                                       const PlanResult& result) {
  std::vector<Executions> executions(result.grasps.size());
  for (const Perturbation& perturbation : perturbations) {
    CompiledScene heavier = scene;
    heavier.scene.object.center_of_mass += perturbation.center_of_mass_O;
    const std::shared_ptr<const RobotModel> hand = hand_model(heavier);
    for_each_in_parallel(result.grasps.size(), 0, [&](std::size_t i) {
      const ScoredGrasp& grasp = result.grasps[i];
      if (grasp.trial.contacts.empty()) return;
      ++executions[i].tried;
      executions[i].lifted += lifts(heavier, hand, grasp, options, perturbation) ? 1 : 0;
    });
  }
  return executions;
}

}  // namespace prehend::bench
