// A plan's grasps and paths in the formats of other programs.
#pragma once

#include <string>
#include <vector>

namespace prehend {

struct CompiledScene;
struct PlanResult;

// A file to be written: its name without a folder, and its bytes (text, or binary for glTF).
struct ExportFile {
  std::string name;
  std::string content;
};

// "json", which stands for grasps.json, then the names of the formats.
std::vector<std::string> export_names();

// The result in one format, as one or several files; none for "json". Nothing is written to disk.
// Throws InputError that lists export_names() when `format` is none of them.
std::vector<ExportFile> export_files(const CompiledScene& scene, const PlanResult& result,
                                     const std::string& format);

}  // namespace prehend
