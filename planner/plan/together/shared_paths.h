// Motions of two arms that take hold of one object and lift it together.
#pragma once

#include <array>
#include <optional>

#include "planner/plan/path/grasp_path.h"
#include "planner/plan/plan_result.h"

namespace prehend {

struct CompiledScene;

// A grasp of one of two arms, in its own scene of the object.
struct SharedHold {
  const CompiledScene& scene;
  const ScoredGrasp& grasp;
};

// The first arm moves, then the second, then both.
struct SharedPaths {
  std::array<Trajectory, 2> reach;  // each from its start to its grasp, the hand closed at the end
  std::array<Trajectory, 2> lift;   // straight up; samples at the same times
};

// The first arm is planned among the links of the second at its start, the second among those of
// the first in its grasp; while both rise, their links are proven apart, the object between them
// as each arm's own. All that plan_grasp_path and lift_object prove holds for each. Both scenes
// have an arm. None where one of them has no way. `options.lift.height` is that of the lift. Throws
// InputError as plan_grasp_path, and Cancelled.
std::optional<SharedPaths> plan_shared_paths(const std::array<SharedHold, 2>& holds,
                                             const GraspPathOptions& options,
                                             const RunContext& context = {});

}  // namespace prehend
