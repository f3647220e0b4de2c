// A plan's grasps and paths in the formats of other programs.
#pragma once

#include <string>
#include <vector>

#include "planner/search/plan.h"

namespace prehend {

struct ExportFile {
  std::string name;
  std::string content;
};

// Formats that files can be asked for in: "json" (grasps.json, always written), "csv", "isaac",
// "moveit", "gltf".
std::vector<std::string> export_formats();

// Files of one format (docs/exports.md). Throws InputError that lists the formats for another.
std::vector<ExportFile> export_files(const CompiledScene& scene, const PlanResult& result,
                                     const std::string& format);

}  // namespace prehend
