// What prehend says of executed grasps.
#pragma once

#include <vector>

#include "planner/plan/plan_options.h"
#include "planner/show/validation/executed_grasps_file.h"
#include "planner/show/validation/scores.h"

namespace prehend {

// The scores of the executions, in the order of the file.
struct JudgedExecutions {
  std::vector<std::vector<double>> scores;  // of each score, one number an execution
  EnumArray<Outcome, int> outcomes;         // of the trials, each counted once
};

// Evaluates the grasps of each object. Which volumes are computed and whether grasps are tried with
// errors follows from `scores`, whatever the options say. The same on any number of threads. Throws
// Cancelled, also when the deadline passes.
JudgedExecutions judge_executions(const ExecutedGrasps& truth, const std::vector<Score>& scores,
                                  EvaluateOptions options, const RunContext& context = {});

}  // namespace prehend
