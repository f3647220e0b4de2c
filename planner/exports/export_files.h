// A plan's grasps and paths in the formats of other programs.
#pragma once

#include <string>
#include <vector>

#include "planner/search/plan.h"

namespace prehend {

// A file to be written: its name without a folder, and its bytes (text, or binary for glTF).
struct ExportFile {
  std::string name;
  std::string content;
};

// The names that export_files accepts as a format: "json" (grasps.json, which is always written),
// "csv", "isaac", "moveit", "gltf".
std::vector<std::string> export_formats();

// The result in one format, as one or several files (docs/exports.md); nothing is written to disk.
// Throws InputError that lists the known formats when `format` is none of them.
std::vector<ExportFile> export_files(const CompiledScene& scene, const PlanResult& result,
                                     const std::string& format);

}  // namespace prehend
