#include <utility>

#include "planner/live/session.h"
#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/base/random.h"
#include "sim/trial/approach_line.h"

// What a session makes of the grasp that its hand holds.
namespace prehend {

TriedGrasp Session::grasp_in_hand() const {
  const CompiledScene& scene = state_.world->compiled();
  TriedGrasp grasp = state_.grasp
                         ? *state_.grasp
                         : grasp_taken_back(scene, state_.hand, std::nullopt, trial_options());
  require(grasp.trial.outcome == Outcome::stable,
          {.field = "hand",
           .problem = "does not hold the object",
           .value = std::string(name_of(grasp.trial.outcome))});
  const bool knows_arm = !grasp.trial.arm_line.empty();
  if (knows_arm || !scene.arm || !state_.arm || !state_.arm->reached()) return grasp;
  grasp.trial.arm_line =
      line_ending_in(*scene.arm, approach_line(scene, grasp.candidate, grasp.trial),
                     state_.arm->dofs, trial_options().reach);
  if (!grasp.trial.arm_line.empty()) grasp.trial.arm_dofs = grasp.trial.arm_line.back();
  return grasp;
}

Refined Session::refine(int trials, std::uint64_t seed) {
  require_in(kRefineTrials, trials, "trials");
  const TriedGrasp grasp = grasp_in_hand();
  TrialOptions options = trial_options();
  options.reach.kinematics.seed = derived_seed(seed);
  const RefineOptions refinement{.grasps = 1, .trials = trials};
  const RunContext context{.threads = options_.threads};
  const std::vector<RefinedGrasp> better =
      refine_grasps(state_.world->compiled(), {grasp}, options, refinement, context);
  Refined refined{grasp.trial.epsilon.lower, grasp.trial.epsilon.lower,
                  refine_trials(1, refinement)};
  if (better.empty()) return refined;
  const Trial& trial = better.front().trial;
  refined.after = trial.epsilon.lower;
  SessionState next = state_;
  next.hand = {hand_in_scene(trial), trial.dofs, trial.joints};
  next.outcome = trial.outcome;
  next.grasp = std::make_shared<const TriedGrasp>(TriedGrasp{better.front().candidate, trial});
  hold_arm(next, trial.arm_dofs);
  push(std::move(next));
  return refined;
}

}  // namespace prehend
