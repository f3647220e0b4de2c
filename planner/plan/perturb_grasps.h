// Every grasp of a result is tried again with the object not quite where it was thought to be
// (sim/trial/perturbed_trials.h), in parallel.
#pragma once

#include "planner/plan/plan_options.h"
#include "planner/plan/plan_result.h"

namespace prehend {

struct CompiledScene;

// Fills in ScoredGrasp::robustness of the grasps, also of those whose hand is blocked, or misses
// the object, where that is thought to be; not of those that the arm cannot carry out. The
// disturbances are the same for all of them, so that differences between grasps are not by chance.
// The same result on any number of threads. Does not throw Cancelled: grasps that were not tried
// when the context was cancelled or its time was over have none, and the result's status says so.
void perturb_grasps(const CompiledScene& scene, const TrialOptions& options,
                    const UncertaintyOptions& uncertainty, std::uint64_t seed,
                    const RunContext& context, PlanResult& result);

// As perturb_grasps, of a result with more grasps than the `top` that are wanted; they are put in
// the order of `by`. The samples are tried in four parts. After each of them, grasps are dropped
// that will hardly be among the first `top`: the interval of the share that held (held_interval)
// lies below those of `top` others. Where time runs out none has a robustness, and those with the
// larger epsilon come first.
void shortlist_grasps(const CompiledScene& scene, const TrialOptions& options,
                      const UncertaintyOptions& uncertainty, std::uint64_t seed, RankBy by, int top,
                      const RunContext& context, PlanResult& result);

// Enters how the grasps ended on a free object (ScoredGrasp::free, or the trial itself where hands
// close in time) into their robustness, where they have both.
void add_free_ends(const CompiledScene& scene, const TrialOptions& options,
                   const RunContext& context, PlanResult& result);

// Puts grasps first that hold in more of their samples, or that lift the object more probably
// (success_probability); of equal ones those with more to spare, then those with the larger mean
// epsilon. Those that were not tried stay behind all others.
void rank_by(RankBy by, PlanResult& result);

}  // namespace prehend
