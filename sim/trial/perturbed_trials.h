// How a grasp fares when the object is not quite where it was thought to be: the same motion of the
// hand, tried on disturbed poses.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "sim/base/run_context.h"
#include "sim/quality/interval.h"
#include "sim/trial/candidate.h"
#include "sim/trial/robustness.h"

namespace prehend {

struct CompiledScene;
struct Perturbation;
struct Trial;
struct TrialOptions;
class TrialWorkspace;

// Distances by which the object is moved to find Robustness::spare [m].
inline constexpr std::array<double, 5> kMarginSteps = {0.0, 1e-3, 2.5e-3, 5e-3, 1e-2};

// The interval that contains the true share with a probability of 90 %, of `held` out of `samples`
// (Wilson 1927).
Interval held_interval(int held, int samples);

// How far a hand comes along its line that is blocked where it is to close, without an approach
// [m].
inline constexpr double kOwnApproach = 0.1;

// The last part of the motion that led from `candidate` to `trial`, as it was commanded, against an
// object that is at X_OC instead: what the hand did besides, stopping at what it touched and giving
// way, it will do again. A hand that had backed off is sent to where it ended. One that was put to
// where it closes, without an approach, is put there again; if it was blocked there, it comes
// kOwnApproach along approach_O. In the frame C.
Candidate replayed_approach(const Candidate& candidate, const Trial& trial, const Pose& X_OC);

// Repeats the motion of `trial`, which `candidate` led to (repeated), for each disturbance: the
// hand comes along the same line, stops where it touches the object, at the latest at the end of
// that line, and closes. It does not back off, and an arm is not asked: it would do the same
// motion. `trial` may have been blocked, or have missed. Throws Cancelled.
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
