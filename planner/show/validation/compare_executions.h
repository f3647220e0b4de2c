// Executed grasps of a file, evaluated and compared: all of a truth report in one call.
#pragma once

#include <filesystem>
#include <optional>

#include "planner/plan/plan_options.h"
#include "planner/show/validation/executed_grasps_file.h"
#include "planner/show/validation/validation_report.h"

namespace prehend {

struct CompareOptions {
  EvaluateOptions evaluation;        // its seed is also that of the resamples
  bool volumes = true;               // the volume of each grasp is a score as well
  std::optional<Grouping> grouping;  // for the intervals; nothing: natural_grouping
  int resamples = 2000;              // >= 1
};

// `file` is named in the report. Which volumes are computed and whether grasps are tried with
// errors follows from `volumes`, whatever the options of the evaluation say. The same on any number
// of threads. Throws Cancelled, also when the deadline passes.
ValidationReport compare_executions(const ExecutedGrasps& truth, const std::filesystem::path& file,
                                    const CompareOptions& options, const RunContext& context = {});

}  // namespace prehend
