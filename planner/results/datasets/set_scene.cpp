#include "planner/results/datasets/set_scene.h"

#include <algorithm>
#include <array>
#include <utility>

#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/base/input_file.h"
#include "sim/robot/files/platform_file.h"
#include "sim/robot/files/robot_file.h"
#include "sim/scene/make_scene.h"
#include "sim/scene/named_mass.h"
#include "sim/scene/object_mass.h"
#include "sim/scene/object_mesh.h"
#include "sim/scene/scene_file.h"
#include "sim/scene/scene_library.h"

namespace prehend {
namespace {

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// ACRONYM's paths begin in the folder that has the one of its grasps in it.
std::string mesh_beside(const GraspSet& set, const std::filesystem::path& file) {
  const std::filesystem::path mesh = set.object.file;
  const std::filesystem::path folder = std::filesystem::absolute(file).parent_path();
  if (!mesh.empty()) {
    for (const std::filesystem::path& name :
         std::array{folder / mesh, folder.parent_path() / mesh, folder / mesh.filename()}) {
      if (is_file(name)) return name.string();
    }
  }
  throw InputError({file.string(), "object.file",
                    "there is no such mesh beside the file: name it with --scene",
                    set.object.file});
}

std::string fitting_hand(const GraspSet& set, const std::filesystem::path& file) {
  require(!set.hand.empty(),
          {.file = file.string(), .problem = "names no hand: name one with --hand"});
  std::string hand = library_hand_called(set.hand);
  if (!hand.empty()) return hand;
  throw InputError({file.string(), "gripper.type",
                    "no hand of the library is called so: name one with --hand", set.hand});
}

// A set says the size of its object by a scale alone, so that its unit is not guessed.
Scene scene_of_mesh(const GraspSetObject& scaled, const std::filesystem::path& file,
                    const std::string& hand, const SetSceneSource& asked) {
  ObjectMesh read = load_object_mesh(file, {asked.unit.empty() ? "m" : asked.unit, asked.repair});
  for (Vector3& vertex : read.mesh.vertices) vertex *= scaled.scale;
  const double mass = scaled.mass > 0.0 ? scaled.mass : kDefaultObjectMass;
  GraspableBody object =
      make_graspable(file.stem().string(), std::move(read.mesh), Material::plastic, mass);
  const std::optional<double> known = scaled.mass > 0.0 ? std::optional(mass) : std::nullopt;
  spread_named_mass(object, prehend::scaled(read.parts, scaled.scale), known, read.notes);
  // Otherwise a file of the scene would name the mesh as it is in its file.
  if (scaled.scale == 1.0) {
    object.source = MeshFileSource{std::filesystem::absolute(file).lexically_normal().string(),
                                   read.unit, asked.repair};
  }
  Scene scene = make_scene(std::move(object), hand);
  scene.notes = std::move(read.notes);
  note_uniform_mass(scene);
  return scene;
}

}  // namespace

std::string library_hand_called(const std::string& name) {
  const std::vector<std::string> robots = library_robot_names();
  if (contains(robots, name)) return find_robot(name).hand ? name : "";
  if (!contains(library_platform_names(), name)) return {};
  const Carrier carrier = find_carrier(name);
  const std::string& hand = carrier.platform.robots[index(carrier.hand)].robot.name;
  return contains(robots, hand) ? hand : "";
}

SetScene load_set_scene(const GraspSet& set, const std::filesystem::path& file,
                        const SetSceneSource& asked) {
  SetScene loaded;
  loaded.source = asked.scene.empty() ? mesh_beside(set, file) : asked.scene;
  loaded.hand = asked.hand.empty() ? fitting_hand(set, file) : asked.hand;
  const std::filesystem::path found = find_scene(loaded.source);
  if (found.extension() == ".json" || found.extension() == ".xml") {
    loaded.scene = load_scene(loaded.source,
                              {.hand = loaded.hand, .unit = asked.unit, .repair = asked.repair});
    loaded.unit = "m";
    return loaded;
  }
  loaded.scene = scene_of_mesh(set.object, found, loaded.hand, asked);
  loaded.unit = asked.unit.empty() ? "m" : asked.unit;
  loaded.scaled = set.object.scale != 1.0;
  return loaded;
}

}  // namespace prehend
