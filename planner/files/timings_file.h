// timings.json as text: what differs from run to run (docs/grasps-file.md).
#pragma once

#include <string>
#include <vector>

#include "planner/search/stopwatch.h"
#include "sim/trial/trial.h"

namespace prehend {

// Seconds a stage, and in all; of the trials also what each of their stages took, summed over the
// threads.
std::string timings_json(const std::vector<StageTime>& times, const TrialSeconds& trials,
                         int threads);

}  // namespace prehend
