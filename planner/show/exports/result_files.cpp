#include "planner/show/exports/result_files.h"

#include <algorithm>
#include <array>
#include <system_error>

#include "planner/show/exports/export_files.h"
#include "planner/show/exports/export_formats.h"
#include "sim/base/output_file.h"

namespace prehend {
namespace {

// Besides the exports. '#' stands for a number.
constexpr std::array<std::string_view, 6> kPlanned = {
    "grasps.json", "timings.json", "report.html", "any.json", "best.png", "best_arm.png"};
constexpr std::array<std::string_view, 4> kSimulated = {"simulation.json", "states.csv",
                                                        "report.html", "moment_#.png"};
constexpr std::array<std::string_view, 3> kRendered = {"contact_sheet.png", "grasp_#.png",
                                                       "approach_#_frame_#.png"};

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// No digit stands beside '#' in the patterns, so that a number ends where the digits end.
bool matches(std::string_view name, std::string_view pattern) {
  std::size_t at = 0;
  for (const char c : pattern) {
    if (c != '#') {
      if (at >= name.size() || name[at] != c) return false;
      ++at;
      continue;
    }
    const std::size_t start = at;
    while (at < name.size() && is_digit(name[at])) ++at;
    if (at == start) return false;
  }
  return at == name.size();
}

// Results of earlier runs may be among them, such as a glTF file.
std::vector<std::filesystem::path> mesh_files(const Scene& scene) {
  std::vector<std::filesystem::path> files;
  const auto add = [&](const ShapeSource& source) {
    if (const auto* file = std::get_if<MeshFileSource>(&source)) files.emplace_back(file->path);
  };
  add(scene.object.source);
  for (const StaticBody& obstacle : scene.obstacles) add(obstacle.source);
  return files;
}

bool is_one_of(std::string_view name, const auto& patterns) {
  return std::any_of(patterns.begin(), patterns.end(),
                     [&](std::string_view pattern) { return matches(name, pattern); });
}

}  // namespace

bool is_result_file(std::string_view name) {
  return is_one_of(name, kPlanned) ||
         std::ranges::any_of(export_formats(), [&](const ExportFormat& format) {
           return is_one_of(name, format.files);
         });
}

bool is_rendered_file(std::string_view name) { return is_one_of(name, kRendered); }

bool is_simulation_file(std::string_view name) { return is_one_of(name, kSimulated); }

void remove_earlier_results(const std::filesystem::path& folder,
                            const std::vector<std::string>& written, const Scene& scene,
                            const std::filesystem::path& input) {
  std::vector<std::filesystem::path> inputs = mesh_files(scene);
  inputs.push_back(input);
  remove_regular_files(folder, [&](const std::string& name) {
    if (!is_result_file(name) && !is_rendered_file(name)) return false;
    if (std::find(written.begin(), written.end(), name) != written.end()) return false;
    return std::none_of(inputs.begin(), inputs.end(), [&](const std::filesystem::path& file) {
      std::error_code missing;
      return std::filesystem::equivalent(folder / name, file, missing);
    });
  });
}

}  // namespace prehend
