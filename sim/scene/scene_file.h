// Reads scene files (docs/scene-file.md) and mesh files, which stand for a scene of one object.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "sim/scene/scene.h"

namespace prehend {

class JsonFile;  // sim/json/json_field.h

// What load_scene takes beside the file.
struct SceneSource {
  // Replaces the hand that the scene names; a name of the library or a robot file. Empty: as it
  // says.
  std::string hand;
  // Unit of a mesh file that is given without a scene: m, cm, mm, in. A scene file says the units
  // of its meshes itself, and another unit than m beside one is an error.
  std::string unit = "m";
};

// The hand of a scene that names none.
inline constexpr const char* kDefaultHand = "barrett";

// A scene file (.json), a GraspIt! world or body (.xml, graspit_world.h), a mesh file as the object
// of a scene with nothing else in it, or, where there is no such file, the library's scene of that
// name
// ("mug", see scene_library.h). Throws InputError that names the file, the field and the value.
Scene load_scene(const std::filesystem::path& name_or_file, const SceneSource& source = {});
// As load_scene, of a scene file that was parsed already.
Scene read_scene(const JsonFile& file, const SceneSource& source = {});

}  // namespace prehend
