#include <algorithm>
#include <functional>

#include "sim/base/data_library.h"
#include "sim/base/input_error.h"
#include "sim/base/input_file.h"
#include "sim/base/joined.h"
#include "sim/base/json/json_field.h"
#include "sim/base/nearest_name.h"
#include "sim/robot/files/foreign_robot.h"
#include "sim/robot/files/platform_file.h"
#include "sim/robot/files/robot_file.h"

namespace prehend {
namespace {

DataLibrary library() { return {"robots", "/robot.json"}; }

bool is_platform(const std::string& name) {
  return JsonFile(library().file(name)).root().has("robots");
}

// Whether this can only be a path. Such a file needs no library, which may be missing.
bool is_path(const std::string& name_or_file) {
  const std::filesystem::path path(name_or_file);
  return path.has_parent_path() || path.extension() == ".json" || has_foreign_robot_name(path);
}

// The file of a library name, else the path as it is.
std::filesystem::path file_of(const std::string& name_or_file) {
  if (is_path(name_or_file) && is_there(name_or_file)) return name_or_file;
  if (is_library_robot(name_or_file)) return library().file(name_or_file);
  if (is_there(name_or_file)) return name_or_file;
  const std::vector<std::string> names = library().names();
  std::string problem = "neither a file nor one of " + joined(names);
  const std::string nearest = nearest_name(name_or_file, names);
  if (!nearest.empty()) problem += "; did you mean " + nearest + "?";
  throw InputError({.field = "robot", .problem = problem, .value = name_or_file});
}

}  // namespace

bool is_library_robot(const std::string& name) {
  const std::vector<std::string> names = library().names();
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::vector<std::string> library_robot_names() {
  std::vector<std::string> names = library().names();
  std::erase_if(names, is_platform);
  return names;
}

std::vector<std::string> library_platform_names() {
  std::vector<std::string> names = library().names();
  std::erase_if(names, std::not_fn(is_platform));
  return names;
}

Robot find_robot(const std::string& name_or_file, const ForeignRobotOptions& options) {
  return load_robot(file_of(name_or_file), options);
}

Platform find_platform(const std::string& name_or_file, const ForeignRobotOptions& options) {
  return load_platform(file_of(name_or_file), options);
}

}  // namespace prehend
