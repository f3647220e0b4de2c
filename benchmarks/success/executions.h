// Grasps that are carried out in simulation: with errors of pose, friction and mass, closed, lifted
// and moved about.
#pragma once

#include <cstdint>
#include <vector>

#include "planner/plan/plan_result.h"
#include "sim/trial/trial_options.h"
#include "sim/trial/uncertainty.h"

namespace prehend::bench {

// How often a grasp was carried out, and how often the object was in the hand at the end.
struct Executions {
  int tried = 0;
  int lifted = 0;
};

// Carries out each grasp of the result once for each disturbance: the hand repeats its approach
// to the disturbed object (replayed_approach) and closes, while that is free to move
// (closed_freely) and has the disturbed friction and centre of mass. What it holds then is lifted
// and swung with its weight, away from what the object stood on. A hand that is blocked or loses
// the object has not lifted it. In the order of the grasps; in parallel.
std::vector<Executions> execute_grasps(const CompiledScene& scene, const TrialOptions& options,
                                       const std::vector<Perturbation>& perturbations,
                                       const PlanResult& result);

}  // namespace prehend::bench
