// grasps.json, written and read (docs/grasps-file.md). It comes in two steps: which scene a file is
// about, and, once that scene is there, the grasps of its hand.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "planner/search/plan.h"

namespace prehend {

class JsonFile;  // sim/json/json_field.h

// What a run was asked, as the file's "scene" and "settings" say it.
struct RunRecord {
  std::string scene;       // name of a library scene or absolute path of a scene or mesh file
  std::string unit = "m";  // of a mesh file
  std::string hand;        // as asked, empty: the scene's
  PlanOptions options;
};

// The whole file as text; the same for the same result, on any number of threads. What is not UTF-8
// in names is U+FFFD.
std::string grasps_json(const CompiledScene& scene, const PlanResult& result,
                        const RunRecord& record);

// The scene that a file is about; what it does not say is empty.
struct SceneReference {
  std::string scene;  // name of a library scene, or path of a scene or mesh file
  std::string hand;
  std::string unit;  // of a mesh file
};

// "scene": a name or path, or {"file", "unit", "hand"}; "hand" may also stand beside it. A relative
// path is first looked for beside the file. Throws InputError that names the file and the field.
SceneReference read_scene_reference(const JsonFile& file);

// What a file says: a run and what came of it, as far as there are fields for it. Of a file that
// holds no more than somebody's grasps, everything else is as in fresh values.
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
