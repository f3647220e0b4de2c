// Paths of the arm to the best grasps of a plan.
#pragma once

#include "planner/plan/plan_options.h"
#include "planner/plan/plan_result.h"

namespace prehend {

struct CompiledScene;

// Plans paths to the ranked grasps of `result`, best first, until options.rank.top have one (or all
// were tried); options.paths must be set. Grasps without a path are left out and counted as
// Outcome::no_path. The same on any number of threads. A cancelled search leaves the grasps whose
// path was found, and the status cancelled.
void find_paths(const CompiledScene& scene, const PlanOptions& options, const RunContext& context,
                PlanResult& result);

}  // namespace prehend
