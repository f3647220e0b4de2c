// grasps.json and timings.json as text (docs/grasps-file.md).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "planner/search/plan.h"

namespace prehend {

// What a run was asked, as the file's "scene" and "settings" say it.
struct RunRecord {
  std::string scene;       // name of a library scene or absolute path of a scene or mesh file
  std::string unit = "m";  // of a mesh file
  std::string hand;        // as asked, empty: the scene's
  PlanOptions options;
};

// The whole file as text; the same for the same result, on any number of threads. What is not UTF-8
// in names is U+FFFD.
std::string grasps_json(const CompiledScene& scene, const PlanResult& result,
                        const RunRecord& record);

// Seconds a stage, and in all; of the trials also what each of their stages took.
std::string timings_json(const std::vector<StageTime>& times, const TrialSeconds& trials,
                         int threads);

}  // namespace prehend
