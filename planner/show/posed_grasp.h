// A grasp that was tried, as something to look at.
#pragma once

#include <string>

#include "planner/search/plan.h"
#include "planner/show/grasp_picture.h"

namespace prehend {

// The hand closed, and where the scene has one and the trial says how, the arm that holds it there.
PosedGrasp posed_grasp(const CompiledScene& scene, const ScoredGrasp& grasp,
                       const std::string& title = "");

}  // namespace prehend
