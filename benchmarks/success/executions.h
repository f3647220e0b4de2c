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

// Carries out each grasp of the result whose hand has closed, once for each disturbance: the hand
// repeats its motion against the disturbed object (replayed_approach), and what it holds then is
// lifted and swung with its weight, with the disturbed friction and centre of mass. A hand that
// does not close on the object has not lifted it. In the order of the grasps; in parallel.
std::vector<Executions> execute_grasps(const CompiledScene& scene, const TrialOptions& options,
                                       const std::vector<Perturbation>& perturbations,
                                       const PlanResult& result);

}  // namespace prehend::bench
