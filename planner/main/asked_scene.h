// The scene that a grasp file is about, as the file and the command line say together.
#pragma once

#include "planner/files/grasps_file.h"
#include "sim/scene/compiled_scene.h"

namespace prehend {

struct LoadedScene {
  CompiledScene scene;
  RunRecord record;
};

// What the command line says stands in place of what the file says; what it leaves empty does not.
// Throws InputError when neither names a scene.
LoadedScene load_asked_scene(const JsonFile& grasps, const SceneReference& command_line);

}  // namespace prehend
