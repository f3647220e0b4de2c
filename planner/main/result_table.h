// Results as text for the terminal.
#pragma once

#include <string>

#include "planner/plan/plan_result.h"

namespace prehend {

struct CompiledScene;

// A row a grasp: rank, epsilon, volume, times the weight that it holds, contacts, outcome or
// primitive. At most `rows`.
std::string grasp_table(const CompiledScene& scene, const PlanResult& result, std::size_t rows);

// "1420 tried: 388 stable, 1001 not_force_closure, ...": one line that counts every outcome.
std::string outcome_line(const PlanResult& result);

// Says where the scene has preferred regions and none of the ranked grasps is there; else empty.
std::string preferred_line(const CompiledScene& scene, const PlanResult& result);

// Of an object that was seen in part, how many of the grasps hold on all of its shapes; else empty.
std::string shapes_line(const PlanResult& result);

// What was not tried, of a result that ran out of time or was cancelled; empty for a complete one.
std::string untested_line(const PlanResult& result);

// "blocked by: table 120 (hand_blocked), ...", a line that is empty where nothing was.
std::string blocker_line(const PlanResult& result);

// Of a plan without a grasp: how the candidates of each rule ended, and what to try. Else empty.
std::string advice_lines(const PlanResult& result);

// "rank 1   epsilon 0.2130 ...": a picture's title.
std::string grasp_title(const ScoredGrasp& grasp, std::size_t rank);

}  // namespace prehend
