// Loads the scene of a grasp file, which the command line may override.
#pragma once

#include "planner/files/grasps_file.h"
#include "sim/scene/compiled_scene.h"

namespace prehend {

// A scene, and how it was asked for.
struct LoadedScene {
  CompiledScene scene;
  RunRecord record;
};

// Each field that is set on the command line overrides that of the file; empty ones do not.
// Throws InputError when neither names a scene.
LoadedScene load_asked_scene(const JsonFile& grasps, const SceneReference& command_line);

// DecomposeOptions::tolerance from --primitive-tolerance [mm]. Throws InputError that names the
// option.
double asked_tolerance(const TriangleMesh& object, double millimetres);

}  // namespace prehend
