#include "sim/scene/scene_library.h"

#include <optional>

#include "sim/base/data_folder.h"
#include "sim/base/data_library.h"

namespace prehend {
namespace {

DataLibrary library() { return {"scenes", ".json"}; }

}  // namespace

std::vector<std::string> library_scene_names() { return library().names(); }

std::filesystem::path find_scene(const std::string& name_or_file) {
  return library().find(name_or_file, "scene");
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
