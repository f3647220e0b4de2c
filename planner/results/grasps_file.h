// Writer and reader of grasps.json (docs/reference/grasps-file.md). Reading takes two steps,
// because grasps can only be checked against their scene: first which scene a file is about
// (read_scene_reference), then, when that scene is loaded, its grasps (read_grasps).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "planner/plan/plan_options.h"
#include "planner/plan/plan_result.h"
#include "sim/scene/surface_region.h"

namespace prehend {

struct CompiledScene;
class JsonFile;  // sim/base/json/json_field.h

// The inputs of a run, which the file repeats as "scene" and "settings".
struct RunRecord {
  std::string scene;       // name of a library scene or absolute path of a scene or mesh file
  std::string unit = "m";  // of a mesh file
  std::string hand;        // as asked, empty: the scene's
  PlanOptions options;
  bool repair = true;  // whether the object's mesh file was repaired
  ObjectChoice choice = {};
  std::optional<double> friction = {};  // as of SceneSource
};

// The whole file as text; the same for the same result, on any number of threads. What is not UTF-8
// in names is U+FFFD.
void write_grasps(std::ostream& stream, const CompiledScene& scene, const PlanResult& result,
                  const RunRecord& record);
// The same as a text.
std::string grasps_json(const CompiledScene& scene, const PlanResult& result,
                        const RunRecord& record);

// The scene that a file is about; fields that the file does not state are empty.
struct SceneReference {
  std::string scene;  // name of a library scene, or path of a scene or mesh file
  std::string hand;
  std::string unit;    // of a mesh file
  bool repair = true;  // of the object's mesh file
  ObjectChoice choice = {};
  std::optional<double> friction = {};  // as of SceneSource
};

// "scene": a name or path, or {"file", "unit", "hand", "repair", "object", "keep_out",
// "preferred"}; "hand" may also stand beside it.
// A relative path is first looked for beside the file. Throws InputError that names the file and
// the field.
SceneReference read_scene_reference(const JsonFile& file);

// The content of a file: the inputs and the result of a run. Fields that the file does not state
// keep their defaults; a file written by hand often has nothing but grasps.
struct GraspFile {
  RunRecord record;
  PlanResult result;
  std::vector<bool> judged;  // of each grasp, whether the file says how its trial ended
};

// Reads what grasps_json writes, and files that say less: of each grasp a pose and a posture are
// enough. The grasps have to fit the scene's hand, and what the file says came of them has to fit
// its arm. Not read are the descriptions of "object", "hand", "robot" and "obstacles", nor what was
// "blocked". Throws InputError that names the file, the grasp and the field, also for unknown
// fields.
GraspFile read_grasps(const JsonFile& file, const CompiledScene& scene);

// The grasps of a file as candidates that are tried where they are: without an approach.
std::vector<Candidate> given_candidates(const GraspFile& file, const CompiledScene& scene);

}  // namespace prehend
