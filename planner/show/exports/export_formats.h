// The formats of other programs that grasps and paths are exported in.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "planner/show/exports/export_files.h"
#include "planner/show/exports/export_grasp.h"

namespace prehend {

struct ScoredGrasp;

// What a format is made from. The grasps of `result` stand in `grasps` as well, in the same order.
struct ExportInput {
  const CompiledScene& scene;
  const PlanResult& result;
  ExportHeader header;
  std::vector<ExportGrasp> grasps;
};

// A format (docs/reference/exports.md). All that is known of it stands here: the command line, the
// protocol and the page of the studio offer it, and what it left is found again (result_files.h).
struct ExportFormat {
  std::string_view name;
  std::vector<std::string_view> files;  // names of its files; '#' stands for a grasp's rank
  std::string_view summary;             // one sentence
  bool is_text = true;                  // can be sent as a message
  std::vector<ExportFile> (*make)(const ExportInput& input) = nullptr;
};

// All of them. grasps.json, which is always written, is none.
std::span<const ExportFormat> export_formats();

// What the formats need of a grasp; `rank` counts from 1.
ExportGrasp export_of(const CompiledScene& scene, const ScoredGrasp& grasp, int rank);

}  // namespace prehend
