// How a grasp fares when the object is not quite where it was thought to be: the same motion of the
// hand, tried on disturbed poses.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "sim/base/run_context.h"
#include "sim/quality/interval.h"
#include "sim/trial/candidate.h"
#include "sim/trial/run_trial.h"
#include "sim/trial/trial.h"
#include "sim/trial/trial_options.h"
#include "sim/trial/uncertainty.h"

namespace prehend {

// What disturbed trials of one grasp showed.
struct Robustness {
  int samples = 0;
  // In so many of them the hand closed on the object and holds its weight as it lies in the scene
  // (can_lift), with the disturbed friction and centre of mass.
  int held = 0;
  // Of the lower bound of epsilon, 0 where a sample is not in force closure: the mean, and the
  // largest value that at most a tenth of the samples are below.
  double epsilon_mean = 0.0;
  double epsilon_low = 0.0;
  std::vector<double> epsilons;      // of the samples, in their order
  EnumArray<Outcome, int> outcomes;  // of the samples
  // How many times the weight the drives hold without errors (weight_strength).
  double strength = 0.0;
  // How far the object may be off, alone, along each axis of the hand's base, both ways, before the
  // hand no longer holds it: at least this far [m], of the distances kMarginSteps. The direction is
  // that in which the object is off, object's frame.
  double position_margin = 0.0;
  Vector3 weakest_O = Vector3::Zero();
  // How the trial ended with the object farther off that way than `spare`; stable: in force
  // closure, but the drives do not hold the weight. Of no meaning where `spare` is the last of
  // kMarginSteps.
  Outcome weakest_end = Outcome::stable;

  // Share of the samples that held.
  double probability() const { return samples > 0 ? static_cast<double>(held) / samples : 0.0; }
};

// Distances by which the object is moved to find Robustness::spare [m].
inline constexpr std::array<double, 5> kMarginSteps = {0.0, 1e-3, 2.5e-3, 5e-3, 1e-2};

// The interval that contains the true share with a probability of 90 %, of `held` out of `samples`
// (Wilson 1927).
Interval held_interval(int held, int samples);

// The last part of the motion that led from `candidate` to `trial`, as it was commanded, against an
// object that is at X_OC instead: what the hand did besides, stopping at what it touched and giving
// way, it will do again. A hand that had backed off is sent to where it ended. In the frame C.
Candidate replayed_approach(const Candidate& candidate, const Trial& trial, const Pose& X_OC);

// Repeats the motion of `trial`, which `candidate` led to (repeated), for each disturbance: the
// hand comes along the same line, stops where it touches the object, at the latest at the end of
// that line, and closes. It does not back off, and an arm is not asked: it would do the same
// motion. `trial` must have closed (contacts). Throws Cancelled.
Robustness try_perturbed(const CompiledScene& scene, const Candidate& candidate, const Trial& trial,
                         const TrialOptions& options,
                         const std::vector<Perturbation>& perturbations, TrialWorkspace& workspace,
                         const RunContext& context = {});

// try_perturbed in parts: what only the samples tell, of these besides those that `robustness` has,
void add_samples(const CompiledScene& scene, const Candidate& candidate, const Trial& trial,
                 const TrialOptions& options, std::span<const Perturbation> perturbations,
                 TrialWorkspace& workspace, const RunContext& context, Robustness& robustness);
// and its strength and what is to spare.
void add_spare(const CompiledScene& scene, const Candidate& candidate, const Trial& trial,
               const TrialOptions& options, TrialWorkspace& workspace, const RunContext& context,
               Robustness& robustness);

}  // namespace prehend
