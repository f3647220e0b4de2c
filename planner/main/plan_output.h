// What the command `plan` writes into a folder.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "planner/main/interrupts.h"
#include "planner/main/plan_command.h"
#include "planner/plan/plan_result.h"
#include "planner/show/exports/export_files.h"

namespace prehend {

class PlanOutput {
 public:
  // The command and the interrupts must outlive it.
  PlanOutput(const PlanCommand& command, Interrupts& interrupts, std::filesystem::path folder)
      : command_(command), interrupts_(interrupts), folder_(std::move(folder)) {}

  const std::filesystem::path& folder() const { return folder_; }
  const std::string& written() const { return written_; }  // names of the files, with commas
  Stopwatch& watch() { return watch_; }

  // grasps.json, timings.json and all exports.
  void write_grasps(const CompiledScene& scene, const PlanResult& result, const RunRecord& record);
  // report.html, where it is wanted.
  void write_report(const CompiledScene& scene, const PlanResult& result, const RunRecord& record);
  // The names of those that are wanted, each after a comma.
  std::string write_pictures(const CompiledScene& scene, const PlanResult& result);
  // The first of them replaces all that is of earlier results.
  void write_files(const Scene& scene, const std::vector<ExportFile>& files);
  void write_timings(const PlanResult& result);

 private:
  const PlanCommand& command_;
  Interrupts& interrupts_;
  std::filesystem::path folder_;
  Stopwatch watch_;
  std::string written_;
  std::optional<Vector3> best_side_;  // of the best grasp, where the report has found it
};

}  // namespace prehend
