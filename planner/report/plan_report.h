// The report of a plan or of grasps that somebody asked for.
#pragma once

#include "planner/files/grasps_file.h"
#include "planner/report/report.h"

namespace prehend {

// Sections of so many wrench spaces are shown, where the result has them.
inline constexpr std::size_t kMostDetailed = 30;

struct PlanReportOptions {
  // Grasps that are listed, and those of them with robustness, wrench space and shares of contacts,
  // which take time to find out and room to say.
  std::size_t most_grasps = 1000;
  std::size_t most_detailed = kMostDetailed;
  // Candidates that are drawn, evenly picked.
  std::size_t most_candidates = 4000;
};

// `scene` must outlive the report. The same on any number of threads. Throws Cancelled.
Report plan_report(const CompiledScene& scene, const PlanResult& result, const RunRecord& record,
                   const PlanReportOptions& options = {}, const RunContext& context = {});

}  // namespace prehend
