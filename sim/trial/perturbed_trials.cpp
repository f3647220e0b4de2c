#include "sim/trial/perturbed_trials.h"

#include <algorithm>
#include <numeric>

#include "sim/motion/dynamic_grasp/scene_world.h"
#include "sim/quality/share_interval.h"
#include "sim/quality/wrench_space.h"
#include "sim/scene/compiled_scene.h"
#include "sim/trial/close_dynamic.h"
#include "sim/trial/grasp_contacts.h"
#include "sim/trial/payload_margin.h"
#include "sim/trial/run_trial.h"
#include "sim/trial/uncertainty.h"

namespace prehend {
namespace {

// The approach is repeated from so far before the grasp: farther away the disturbed object is not
// met either [m].
constexpr double kRepeatedApproach = 0.05;

class DisturbedTrials {
 public:
  DisturbedTrials(const CompiledScene& scene, const Candidate& candidate, const Trial& trial,
                  const TrialOptions& options, TrialWorkspace& workspace, const RunContext& context)
      : scene_(scene),
        candidate_(candidate),
        first_(trial),
        options_(options),
        workspace_(workspace),
        context_(context) {
    options_.back_off_tries = 0;
  }

  bool holds(const Perturbation& perturbation) {
    motion_ = replayed_approach(candidate_, first_, perturbation.X_OC);
    run_hand_trial(scene_, motion_, options_, workspace_, trial_, context_);
    return !trial_.contacts.empty() && can_lift(scene_, trial_, perturbation);
  }

  // With friction as disturbed.
  double epsilon(const Perturbation& perturbation) const {
    if (trial_.contacts.empty()) return 0.0;
    const std::vector<Contact> contacts =
        with_friction_of(perturbation, contacts_of(trial_.contacts));
    return grasp_epsilon(contacts, scene_.wrench_frame, {.edges = options_.cone_edges}).lower;
  }

  bool closed() const { return !trial_.contacts.empty(); }
  double strength() const { return weight_strength(scene_, trial_); }

  std::optional<FreeEnd> free() const {
    if (!scene_.scene.hand.hand->cups.empty()) return std::nullopt;
    if (options_.formation.dynamic) return free_end(scene_, trial_);
    return free_end(scene_,
                    closed_freely(scene_, hand_model(scene_), motion_, trial_, options_, context_));
  }

  // The last of kMarginSteps up to which the object may be off in this direction, of those up to
  // `most`. Below `most`, outcome() is afterwards that of the step beyond.
  double position_margin(const Vector3& direction_O, double most) {
    double held = 0.0;
    for (std::size_t i = 1; i < kMarginSteps.size() && kMarginSteps[i] <= most; ++i) {
      Perturbation off;
      off.X_OC = translation(kMarginSteps[i] * direction_O);
      if (!holds(off)) break;
      held = kMarginSteps[i];
    }
    return held;
  }

  Outcome outcome() const { return trial_.outcome; }
  const Pose& X_OH() const { return candidate_.X_OH; }

 private:
  const CompiledScene& scene_;
  const Candidate& candidate_;
  const Trial& first_;
  TrialOptions options_;
  TrialWorkspace& workspace_;
  const RunContext& context_;
  Candidate motion_;
  Trial trial_;
};

void find_spare(DisturbedTrials& trials, Robustness& robustness) {
  robustness.position_margin = kMarginSteps.back();
  for (int axis = 0; axis < 3; ++axis) {
    for (const double way : {1.0, -1.0}) {
      const Vector3 direction_O = way * trials.X_OH().linear().col(axis);
      // A direction in which more is to spare than in the weakest so far need not be known.
      const double position_margin =
          trials.position_margin(direction_O, robustness.position_margin);
      if (position_margin >= robustness.position_margin) continue;
      robustness.position_margin = position_margin;
      robustness.weakest_O = direction_O;
      robustness.weakest_end = trials.outcome();
    }
  }
}

}  // namespace

Candidate replayed_approach(const Candidate& candidate, const Trial& trial, const Pose& X_OC) {
  Candidate again = candidate;
  const double end = trial.back_offs > 0 ? trial.travel : candidate.approach_distance;
  const double left = candidate.approach_distance - end;
  const double repeated = end - std::max(0.0, trial.travel - kRepeatedApproach);
  const Pose X_CO = X_OC.inverse();
  again.X_OH = X_CO * translation(-left * candidate.approach_O) * candidate.X_OH;
  again.approach_O = X_CO.linear() * candidate.approach_O;
  const bool comes = candidate.approach_distance > 0.0 || !is_blocked(trial.outcome);
  again.approach_distance = comes ? repeated : kOwnApproach;
  return again;
}

Interval held_interval(int held, int samples) { return share_interval(held, samples, kQuantile90); }

void add_samples(const CompiledScene& scene, const Candidate& candidate, const Trial& trial,
                 const TrialOptions& options, std::span<const Perturbation> perturbations,
                 TrialWorkspace& workspace, const RunContext& context, Robustness& robustness) {
  DisturbedTrials trials(scene, candidate, trial, options, workspace, context);
  bool stands_for = trial.contacts.empty() && robustness.closed() == 0;
  for (const Perturbation& perturbation : perturbations) {
    context.cancellation.check();
    robustness.held += trials.holds(perturbation) ? 1 : 0;
    if (stands_for && trials.closed()) {
      robustness.strength = trials.strength();
      robustness.free = trials.free();
      stands_for = false;
    }
    ++robustness.outcomes[trials.outcome()];
    robustness.epsilons.push_back(trials.epsilon(perturbation));
  }
  std::vector<double> epsilons = robustness.epsilons;
  robustness.samples = static_cast<int>(epsilons.size());
  if (epsilons.empty()) return;
  robustness.epsilon_mean =
      std::accumulate(epsilons.begin(), epsilons.end(), 0.0) / static_cast<double>(epsilons.size());
  std::sort(epsilons.begin(), epsilons.end());
  robustness.epsilon_low = epsilons[epsilons.size() / 10];
}

void add_spare(const CompiledScene& scene, const Candidate& candidate, const Trial& trial,
               const TrialOptions& options, TrialWorkspace& workspace, const RunContext& context,
               Robustness& robustness) {
  if (trial.contacts.empty()) return;
  robustness.strength = weight_strength(scene, trial);
  if (robustness.samples == 0) return;
  DisturbedTrials trials(scene, candidate, trial, options, workspace, context);
  find_spare(trials, robustness);
}

Robustness try_perturbed(const CompiledScene& scene, const Candidate& candidate, const Trial& trial,
                         const TrialOptions& options,
                         const std::vector<Perturbation>& perturbations, TrialWorkspace& workspace,
                         const RunContext& context) {
  Robustness robustness;
  add_samples(scene, candidate, trial, options, perturbations, workspace, context, robustness);
  add_spare(scene, candidate, trial, options, workspace, context, robustness);
  return robustness;
}

}  // namespace prehend
