// Reads scene files (docs/reference/scene-file.md) and mesh files, which stand for a scene of one
// object.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sim/robot/files/package_folders.h"
#include "sim/scene/scene.h"

namespace prehend {

class JsonFile;  // sim/base/json/json_field.h

// What load_scene takes beside the file.
struct SceneSource {
  // Replaces the hand that the scene names; a name of the library or a robot file. Empty: as it
  // says.
  std::string hand;
  // The platform of a scene of MoveIt: a name of the library or a robot file. Empty: the one of the
  // library that the scene names. An error beside other files.
  std::string robot = {};
  // Unit of a mesh file that is given without a scene: m, cm, mm, in; empty: the likely one
  // (object_mesh.h). A scene file says the units of its meshes itself, and another unit than m
  // beside one is an error.
  std::string unit = {};
  // Whether the surface of the object is repaired where it comes from a mesh file; a scene file may
  // switch it off itself.
  bool repair = true;
  // Of hands and platforms in another program's format.
  ForeignRobotOptions foreign = {};
  // Whether the hand of a GraspIt! world is derived (derive_hand.h). Without that it is as its file
  // states it, maybe without preshapes: a scene to look at, which cannot be compiled.
  bool derive_hand = true;
  ObjectChoice choice = {};
  // Whether a scene without an object is an error; else it gets nothing_to_grasp (make_scene.h).
  bool needs_object = true;
  // Static friction of the object with everything, in place of what the file says
  // (set_object_friction). Empty: as it says. Only load_scene and load_each_scene look at it.
  std::optional<double> friction = {};
};

// The hand of a scene that names none.
inline constexpr const char* kDefaultHand = "barrett";

// A scene file (.json), a scene of MoveIt (.yaml, moveit_scene.h), a GraspIt! world or body (.xml,
// graspit_world.h), a mesh file as the object of a scene with nothing else in it, what depth
// cameras saw (seen_scene.h, a file of is_views_file) as the object and all else, or, where there
// is no such file, the library's scene of that name ("mug", see scene_library.h). Throws InputError
// that names the file, the field and the value.
Scene load_scene(const std::filesystem::path& name_or_file, const SceneSource& source = {});
// The unit in which load_scene has read the mesh file that was given in place of a scene; m for a
// scene file.
std::string unit_of_source(const std::filesystem::path& name_or_file, const Scene& scene);
// The names of the objects of a scene file, in its order, or of the things that cameras saw; empty
// where it is neither, or names one object only. `unit` as in SceneSource. Throws InputError.
std::vector<std::string> scene_objects(const std::filesystem::path& name_or_file,
                                       const std::string& unit = {});
// The scene of each of these objects, the others being obstacles: load_scene with each as its
// choice. What cameras saw is reconstructed once. Throws InputError.
std::vector<Scene> load_each_scene(const std::filesystem::path& name_or_file,
                                   const SceneSource& source = {});
// As load_scene, of a scene file that was parsed already.
Scene read_scene(const JsonFile& file, const SceneSource& source = {});

}  // namespace prehend
