// Finds out what may help where a plan has no grasp, by trying it.
#pragma once

#include <vector>

#include "planner/plan/plan_options.h"
#include "planner/plan/plan_result.h"

namespace prehend {

struct CompiledScene;

// Hints for a plan of `scene` that was completed without a grasp, in the order of Hint. `tried` are
// the trials of the plan, in the order of result.tried. Tries a few candidates of each of a few
// variants of the scene and the options: soft contacts, more friction, the other hands of the
// library (which are read from the data folder; where there is none, no hand is suggested), a finer
// tolerance of the primitives, no obstacle, no arm, another unit of the mesh. The same on any
// number of threads. Throws Cancelled.
std::vector<Advice> find_advice(const CompiledScene& scene, const PlanOptions& options,
                                const PlanResult& result, const std::vector<Trial>& tried,
                                const RunContext& context = {});

}  // namespace prehend
