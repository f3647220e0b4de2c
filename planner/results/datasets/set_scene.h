// The scene that a set of grasps is about: its object, in the size in which it was grasped, and a
// hand.
#pragma once

#include <filesystem>
#include <string>

#include "planner/results/datasets/grasp_set.h"
#include "sim/scene/scene.h"

namespace prehend {

// What is asked for in the place of what the set says; empty: as it says.
struct SetSceneSource {
  std::string scene = {};  // of a mesh file the set's scale is applied, of a scene nothing
  std::string hand = {};   // a name of the library or a robot file
  std::string unit = {};   // of a mesh file, before it is scaled; empty: m
  bool repair = true;      // of a mesh file
};

struct SetScene {
  Scene scene;
  std::string source;   // name of a library scene, or path of the scene or mesh file
  std::string unit;     // in which the mesh file was read; m of a scene
  std::string hand;     // as asked for, or the library's
  bool scaled = false;  // the object is not as large as the file says
};

// The set's mesh is looked for beside `file`, the file that the set was read from, and in the
// folder above it. Throws InputError that names the file where there is no such mesh and none was
// asked for, where no hand fits the set's and none was asked for, and as load_scene.
SetScene load_set_scene(const GraspSet& set, const std::filesystem::path& file,
                        const SetSceneSource& asked);

// The hand of the library that data sets call `name`: one of that name, or the one that a platform
// of that name carries. Empty where there is none.
std::string library_hand_called(const std::string& name);

}  // namespace prehend
