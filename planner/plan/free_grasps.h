// The best grasps of a plan on an object that is free to move while the hand closes.
#pragma once

#include "planner/plan/plan_options.h"
#include "planner/plan/plan_result.h"

namespace prehend {

struct CompiledScene;

// Fills in ScoredGrasp::free of the grasps, in their order, until options.free_closing of them (at
// most options.rank.top) hold the object firmly, in force closure and less than 20 mm from where it
// stood on something, or options.rank.pool times as many have been tried. A hand that does not
// closes again by its strategies, until one does (Candidate::strategy); a strategy that helped none
// of as many grasps as are wanted is not tried any more. Where success is asked for, by
// options.robustness, others follow until options.rank.top keep the object, or options.rank.pool
// times as many have been tried. Those that lose the object are left out and counted under the
// outcome of that trial, unless all that were tried do. If grasps are ranked by epsilon, those that
// hold firmly come first, by the epsilon where the object ended, then those that do not, then those
// not tried. The same on any number of threads. Does not throw Cancelled: what was not tried by
// then has none.
void free_grasps(const CompiledScene& scene, const PlanOptions& options, const RunContext& context,
                 PlanResult& result);

// Fills in ScoredGrasp::free of all grasps in which the hand has closed on the object, and changes
// nothing else but the status where time runs out.
void close_freely(const CompiledScene& scene, const TrialOptions& options,
                  const RunContext& context, PlanResult& result);

}  // namespace prehend
