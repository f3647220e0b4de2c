// The report on the result of plan() or evaluate().
#pragma once

#include "planner/results/grasps_file.h"
#include "planner/show/report/report.h"

namespace prehend {

// For how many grasps sections of the wrench space are shown, where the result has them.
inline constexpr std::size_t kMostDetailed = 30;

// Limits that keep a report small and quick to make.
struct PlanReportOptions {
  // Number of grasps that are listed, and of those with a GraspDetail (robustness, wrench space,
  // importance of contacts), which takes time to compute and room in the file.
  std::size_t most_grasps = 1000;
  std::size_t most_detailed = kMostDetailed;
  // Number of candidates that are drawn as arrows, picked evenly from all.
  std::size_t most_candidates = 4000;
};

// The report on `result`, which plan() or evaluate() returned for `scene`; `record` says what was
// asked. `scene` must outlive the report. The same on any number of threads. Throws Cancelled.
Report plan_report(const CompiledScene& scene, const PlanResult& result, const RunRecord& record,
                   const PlanReportOptions& options = {}, const RunContext& context = {});

}  // namespace prehend
