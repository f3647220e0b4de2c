// A plan's grasps and paths in the formats of other programs.
#pragma once

#include <string>
#include <vector>

#include "planner/plan/plan_result.h"
#include "planner/show/exports/export_grasp.h"

namespace prehend {

// A file to be written: its name without a folder, and its bytes (text, or binary for glTF).
struct ExportFile {
  std::string name;
  std::string content;
};

// The names that export_files accepts as a format: "json" (grasps.json, which is always written),
// "csv", "isaac", "moveit", "gltf", "mjcf".
std::vector<std::string> export_formats();

// What the formats need of a grasp; `rank` counts from 1.
ExportGrasp export_of(const CompiledScene& scene, const ScoredGrasp& grasp, int rank);

// The result in one format, as one or several files (docs/exports.md); nothing is written to disk.
// Throws InputError that lists the known formats when `format` is none of them.
std::vector<ExportFile> export_files(const CompiledScene& scene, const PlanResult& result,
                                     const std::string& format);

}  // namespace prehend
