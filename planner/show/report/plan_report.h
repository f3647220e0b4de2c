// The report on the result of plan() or evaluate().
#pragma once

#include "planner/show/report/report.h"
#include "sim/base/run_context.h"

namespace prehend {

struct CompiledScene;
struct PlanResult;
struct RunRecord;

// For how many grasps, the first ones, a report has a GraspDetail (robustness, wrench space,
// importance of contacts), which takes time to compute and room in the file.
inline constexpr std::size_t kMostDetailed = 30;

// The report on `result`, which plan() or evaluate() returned for `scene`; `record` says what was
// asked. At most 1000 grasps are listed, and 4000 candidates drawn as arrows, evenly from all.
// `scene` must outlive the report. The same on any number of threads. Throws Cancelled.
Report plan_report(const CompiledScene& scene, const PlanResult& result, const RunRecord& record,
                   std::size_t most_detailed = kMostDetailed, const RunContext& context = {});

}  // namespace prehend
