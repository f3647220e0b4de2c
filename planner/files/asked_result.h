// What a grasp file says came of its grasps.
#pragma once

#include "planner/files/asked_grasps.h"
#include "planner/search/plan.h"

namespace prehend {

// An entry of "grasps" as the trial that its fields tell of: where the fingers ended ("joints",
// else where they start), "contacts", "weakest_wrench", "epsilon", "volume", "outcome", the
// "approach" ("direction" and "travel"), and in a scene with an arm its "arm_dofs", "arm_line" and
// "path". What the file leaves out is as in a fresh ScoredGrasp, and `asked` is what asked_grasps
// made of the same entry. Throws InputError that names the file, the grasp and the field.
ScoredGrasp asked_result(const JsonField& grasp, const AskedGrasp& asked,
                         const CompiledScene& scene);

}  // namespace prehend
