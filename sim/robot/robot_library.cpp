#include <algorithm>

#include "sim/geometry/input_error.h"
#include "sim/robot/robot_file.h"

namespace prehend {
namespace {

constexpr const char* kRobotFile = "robot.json";

std::filesystem::path library() { return PREHEND_ROBOTS_DIR; }

}  // namespace

std::vector<std::string> library_robot_names() {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(library(), error)) {
    if (std::filesystem::exists(entry.path() / kRobotFile)) {
      names.push_back(entry.path().filename().string());
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

Robot find_robot(const std::string& name_or_file) {
  const std::vector<std::string> names = library_robot_names();
  if (std::find(names.begin(), names.end(), name_or_file) != names.end()) {
    return load_robot(library() / name_or_file / kRobotFile);
  }
  if (std::filesystem::exists(name_or_file)) return load_robot(name_or_file);
  std::string known;
  for (const std::string& name : names) known += (known.empty() ? "" : ", ") + name;
  throw InputError("robot: neither a file nor one of " + known + " (" + name_or_file + ")");
}

}  // namespace prehend
