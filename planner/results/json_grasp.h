// One grasp in a grasp file: an entry of "grasps" (docs/reference/grasps-file.md).
#pragma once

#include <vector>

#include "planner/plan/plan_result.h"
#include "sim/base/json/json_field.h"

namespace prehend {

struct CompiledScene;

nlohmann::ordered_json grasp_to_json(const ScoredGrasp& grasp, const CompiledScene& scene,
                                     const std::vector<Primitive>& primitives);

struct ReadGrasp {
  ScoredGrasp grasp;
  bool judged = false;  // the file says how its trial ended
};

// A pose ("X_object_hand" or "X_world_hand") and a posture ("preshape", "joints" or "dofs") are
// needed; what the file leaves out is as in a fresh ScoredGrasp, save that
// - the approach is along the hand's own direction where the file gives none,
// - the fingers stand where they start where it does not say where they ended,
// - an outcome that is missing follows from a given epsilon.
// "arm_dofs", "arm_line" and "path" are read where the scene has an arm. What the trial was blocked
// by is not read. Throws InputError that names the file, the grasp and the field, also for fields
// that no grasp has.
ReadGrasp read_grasp(const JsonField& field, const CompiledScene& scene,
                     const std::vector<Primitive>& primitives);

// The JSON schema of an entry as grasp_to_json writes it.
nlohmann::ordered_json grasp_schema();

}  // namespace prehend
