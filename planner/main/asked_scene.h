// The scene that a grasp file is about, as the file and the command line say together.
#pragma once

#include <string>

#include "planner/files/asked_grasps.h"
#include "planner/files/grasps_file.h"
#include "sim/scene/compiled_scene.h"

namespace prehend {

// Words of the command line; empty ones leave it to the grasp file.
struct SceneWords {
  std::string scene;
  std::string hand;
  std::string unit;
};

struct LoadedScene {
  CompiledScene scene;
  RunRecord record;
};

// Throws InputError when neither names a scene.
LoadedScene load_asked_scene(const JsonFile& grasps, const SceneWords& words);

}  // namespace prehend
