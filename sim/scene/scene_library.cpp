#include "sim/scene/scene_library.h"

#include <algorithm>
#include <optional>

#include "sim/base/data_folder.h"
#include "sim/base/input_error.h"
#include "sim/base/input_file.h"
#include "sim/base/joined.h"

namespace prehend {
namespace {

std::filesystem::path library() { return data_folder() / "scenes"; }

}  // namespace

std::vector<std::string> library_scene_names() {
  std::vector<std::string> names;
  std::error_code missing;
  for (const auto& entry : std::filesystem::directory_iterator(library(), missing)) {
    if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::filesystem::path find_scene(const std::string& name_or_file) {
  if (is_there(name_or_file)) return name_or_file;
  const std::filesystem::path in_library = library() / (name_or_file + ".json");
  const bool is_name = name_or_file.find('/') == std::string::npos;
  if (is_name && is_there(in_library)) return in_library;
  const std::string names = joined(library_scene_names());
  throw InputError({.file = name_or_file,
                    .problem = "no such file, and no scene of that name (scenes: " + names + ")"});
}

std::string scene_reference(const std::filesystem::path& name_or_file) {
  const std::filesystem::path file = find_scene(name_or_file.string());
  // A scene file of one's own can be named without a library.
  const std::optional<std::filesystem::path> data = find_data_folder();
  std::error_code missing;
  if (data && std::filesystem::equivalent(file.parent_path(), *data / "scenes", missing)) {
    return file.stem().string();
  }
  return std::filesystem::absolute(file).lexically_normal().string();
}

}  // namespace prehend
