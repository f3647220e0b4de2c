// Where a grasp came from, in words.
#pragma once

#include <string>

#include "planner/search/plan.h"

namespace prehend {

// "cylinder 1 (cylinder side, thumb across)"; "given" for one that somebody asked for.
std::string origin_words(const ScoredGrasp& grasp, const PlanResult& result);

// The opening that the hand came with; empty where it has no name.
std::string preshape_name(const CompiledScene& scene, const Candidate& candidate);

}  // namespace prehend
