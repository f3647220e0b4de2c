// What is said of the grasps that a run returns besides epsilon, by which it ranks them.
#pragma once

#include <cstddef>
#include <limits>

#include "planner/plan/plan_options.h"
#include "planner/plan/plan_result.h"

namespace prehend {

struct CompiledScene;

// For how many of the grasps, the first ones.
struct WantedMeasures {
  std::size_t volumes = std::numeric_limits<std::size_t>::max();  // epsilon_nearby, holding
  std::size_t sections = 0;                                       // at most `volumes`
};

// Adds volumes, sections of the wrench space, epsilon_nearby and the holding to the grasps of
// `result`. A cancelled run leaves out the rest and sets the status cancelled.
void measure_grasps(const CompiledScene& scene, const TrialOptions& options,
                    const WantedMeasures& wanted, const RunContext& context, PlanResult& result);

}  // namespace prehend
