#include "sim/robot/files/converted.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "sim/base/input_error.h"
#include "sim/base/input_file.h"
#include "sim/robot/files/foreign_robot.h"
#include "sim/robot/files/platform_file.h"
#include "sim/robot/files/sphere_model.h"
#include "sim/robot/files/srdf_text.h"
#include "sim/robot/files/urdf_text.h"
#include "sim/robot/files/xrdf_text.h"
#include "sim/shape/files/mesh_file.h"
#include "sim/shape/files/mesh_text.h"

namespace prehend {
namespace {

void require_another_file(const std::string& source, const std::filesystem::path& target) {
  std::error_code error;
  if (is_there(source) && std::filesystem::equivalent(source, target, error)) {
    throw InputError({.file = target.string(), .problem = "is the file that would be converted"});
  }
}

}  // namespace

std::vector<RobotTextFile> converted(const std::string& source, const std::filesystem::path& target,
                                     const std::string& unit, const ForeignRobotOptions& foreign,
                                     std::vector<std::string>& notes) {
  require_another_file(source, target);
  const std::string extension = target.extension().string();
  if (is_written_mesh_name(target)) {
    const LoadedMesh loaded = load_mesh(source, {.metres_per_unit = metres_per_unit(unit)});
    if (loaded.degenerate_removed + loaded.duplicates_removed > 0) {
      notes.push_back(std::to_string(loaded.degenerate_removed) + " triangles without area and " +
                      std::to_string(loaded.duplicates_removed) + " duplicates are left out");
    }
    return {{target.filename(), mesh_text(loaded.mesh, target)}};
  }
  constexpr std::array<std::string_view, 4> kRobots = {".json", ".urdf", ".xrdf", ".srdf"};
  if (std::find(kRobots.begin(), kRobots.end(), extension) == kRobots.end()) {
    throw InputError({.file = target.string(),
                      .problem = "unknown format to write, known are .json, .urdf, .xrdf and .srdf "
                                 "for robots, .obj .stl .ply .off for meshes",
                      .value = extension});
  }
  ForeignRobotOptions options = foreign;
  if (unit != "m") {
    require(is_there(source) && has_foreign_robot_name(source),
            {.field = "unit",
             .problem = "only for meshes and robots in another program's format, not for our own",
             .value = unit});
    options.scale = metres_per_unit(unit);
  }
  const Platform platform = find_platform(source, options);
  for (const MountedRobot& mounted : platform.robots) {
    notes.insert(notes.end(), mounted.robot.notes.begin(), mounted.robot.notes.end());
  }
  if (extension == ".urdf") return urdf_text(platform, target);
  if (extension == ".xrdf") return {{target.filename(), xrdf_text(sphere_model(platform))}};
  if (extension == ".srdf") return {{target.filename(), srdf_text(sphere_model(platform))}};
  return platform_text(platform, target);
}

}  // namespace prehend
