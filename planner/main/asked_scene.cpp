#include "planner/main/asked_scene.h"

#include "sim/base/input_error.h"
#include "sim/scene/scene_file.h"
#include "sim/scene/scene_library.h"

namespace prehend {
namespace {

std::string first_of(const std::string& word, const std::optional<std::string>& in_file,
                     const char* otherwise) {
  return !word.empty() ? word : in_file.value_or(otherwise);
}

}  // namespace

LoadedScene load_asked_scene(const JsonFile& grasps, const SceneWords& words) {
  const AskedScene asked = asked_scene(grasps);
  const std::string name = first_of(words.scene, asked.file, "");
  if (name.empty()) {
    throw InputError(grasps.path().string() + ": scene: missing; name it there or with --scene");
  }
  RunRecord record;
  record.unit = first_of(words.unit, asked.unit, "m");
  record.hand = first_of(words.hand, asked.hand, "");
  const std::filesystem::path file = find_scene(name);
  record.scene = scene_reference(file);
  return {compile(load_scene(file, {record.hand, record.unit})), record};
}

}  // namespace prehend
