#include <algorithm>

#include "sim/base/data_folder.h"
#include "sim/base/input_error.h"
#include "sim/base/input_file.h"
#include "sim/base/joined.h"
#include "sim/base/json/json_field.h"
#include "sim/robot/files/foreign_robot.h"
#include "sim/robot/files/platform_file.h"
#include "sim/robot/files/robot_file.h"

namespace prehend {
namespace {

constexpr const char* kRobotFile = "robot.json";

std::filesystem::path library() { return data_folder() / "robots"; }

bool is_platform(const std::filesystem::path& file) { return JsonFile(file).root().has("robots"); }

std::vector<std::string> names_in_library() {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(library(), error)) {
    if (is_there(entry.path() / kRobotFile)) {
      names.push_back(entry.path().filename().string());
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

// Whether this can only be a path. Such a file needs no library, which may be missing.
bool is_path(const std::string& name_or_file) {
  const std::filesystem::path path(name_or_file);
  return path.has_parent_path() || path.extension() == ".json" || has_foreign_robot_name(path);
}

// The file of a library name, else the path as it is.
std::filesystem::path file_of(const std::string& name_or_file) {
  if (is_path(name_or_file) && is_there(name_or_file)) return name_or_file;
  const std::vector<std::string> names = names_in_library();
  if (std::find(names.begin(), names.end(), name_or_file) != names.end()) {
    return library() / name_or_file / kRobotFile;
  }
  if (is_there(name_or_file)) return name_or_file;
  const std::string known = joined(names);
  throw InputError(
      {.field = "robot", .problem = "neither a file nor one of " + known, .value = name_or_file});
}

}  // namespace

std::vector<std::string> library_robot_names() {
  std::vector<std::string> names = names_in_library();
  std::erase_if(names,
                [](const std::string& name) { return is_platform(library() / name / kRobotFile); });
  return names;
}

std::vector<std::string> library_platform_names() {
  std::vector<std::string> names = names_in_library();
  std::erase_if(
      names, [](const std::string& name) { return !is_platform(library() / name / kRobotFile); });
  return names;
}

Robot find_robot(const std::string& name_or_file, const ForeignRobotOptions& options) {
  return load_robot(file_of(name_or_file), options);
}

Platform find_platform(const std::string& name_or_file, const ForeignRobotOptions& options) {
  return load_platform(file_of(name_or_file), options);
}

}  // namespace prehend
