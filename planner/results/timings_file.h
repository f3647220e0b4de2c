// timings.json as text: run times, kept out of grasps.json since they differ from run to run
// (docs/reference/grasps-file.md).
#pragma once

#include <string>
#include <vector>

#include "planner/plan/stopwatch.h"
#include "sim/trial/trial.h"

namespace prehend {

// Seconds of each stage and in total; for trials also the time of each of their stages, summed over
// all threads.
std::string timings_json(const std::vector<StageTime>& times, const TrialSeconds& trials,
                         int threads);

}  // namespace prehend
