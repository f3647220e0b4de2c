// Loads the scene of a grasp file, which the command line may override.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "planner/results/datasets/grasp_set.h"
#include "planner/results/grasps_file.h"
#include "sim/manipulation/test_procedure.h"
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

// The scene of a set of grasps that was read from `file`, as above. Where the object was scaled,
// the record names `scaled`, a scene file that has yet to be written (scene_text).
LoadedScene load_asked_scene(const GraspSet& set, const std::filesystem::path& file,
                             const SceneReference& command_line,
                             const std::filesystem::path& scaled);

// The protocol that --shake names; nothing where it does not. Throws InputError.
std::optional<TestProcedure> requested_test_procedure(const std::string& name_or_file);

// The options of --accuracy (read_accuracy); prints a note for each setting in its file that has no
// effect any more. Throws InputError.
PlanOptions requested_accuracy(const std::string& name_or_file);

// The limit that --approach states (approach_limit). Throws InputError that names the option.
ApproachLimit requested_approach(const std::string& words);

// DecomposeOptions::tolerance from --primitive-tolerance [mm]. Throws InputError that names the
// option.
double requested_tolerance(const TriangleMesh& object, double millimetres);

}  // namespace prehend
