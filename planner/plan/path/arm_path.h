// Planning of the timed motion of an arm from where its scene starts to a posture, without a grasp.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "planner/plan/path/grasp_path.h"
#include "sim/base/named_enum.h"
#include "sim/base/pose.h"

namespace prehend {

// How the search for a path ended.
enum class ArmPathEnd {
  found,
  unreachable,    // no posture has the hand there
  beyond_limits,  // the goal is beyond the limits of a degree of freedom
  goal_collides,  // at the goal two bodies meet
  not_found,      // the search ended after its iterations
  refused,        // a path was found, and the independent check refused it
  line_jumps,     // a straight line of the hand takes a joint through a jump: a singular posture
  line_blocked,   // two bodies meet along a straight line of the hand, or that was not ruled out
};

// The outcome's name in files and on the command line.
constexpr auto enum_names(ArmPathEnd /*of*/) {
  return std::to_array<std::string_view>({"found", "unreachable", "beyond_limits", "goal_collides",
                                          "not_found", "refused", "line_jumps", "line_blocked"});
}

// A path and what the check measured along it, or why there is none.
struct ArmPath {
  ArmPathEnd end = ArmPathEnd::unreachable;
  // Of beyond_limits, goal_collides, line_blocked and refused: "LINK meets BODY", ...; of not_found
  // what blocked most motions that were tried: "mostly LINK meets BODY"; of a line that the arm
  // does not follow to its end: "after 37 % of the line".
  std::string why;
  Trajectory motion;  // one segment, "transfer" or "line"; joints of the platform, in its order
  std::vector<DofValues> waypoints;  // of the lines in joint space whose corners it rounds off
  PathCheck check;
};

// The path from the scene's start to the first of `goals` (degrees of freedom of the platform) that
// has one; else the failure of the goal that came farthest. The hand keeps its joints. Uses
// transfer, timing and check of the options. No goals: unreachable. The scene must have an arm.
// Throws InputError for a degree of freedom that moves without a velocity or acceleration limit,
// and Cancelled.
ArmPath plan_arm_path(const CompiledScene& scene, const std::vector<DofValues>& goals,
                      const GraspPathOptions& options = {}, const RunContext& context = {});

// The motion from the scene's start on which the hand moves in a straight line, turning at a
// constant rate about one axis, until its base has the pose X_WH in the world. All of it is proven
// free of collision (first_blocked), and tested again by check_path. Uses reach, timing, check and
// transfer.motion of the options. The scene must have an arm. Throws as plan_arm_path.
ArmPath plan_arm_line(const CompiledScene& scene, const Pose& X_WH,
                      const GraspPathOptions& options = {}, const RunContext& context = {});

// Length of the way along `waypoints` over that of the straight line from its first to its last, in
// the degrees of freedom; 1 where both are the same.
double relative_length(const std::vector<DofValues>& waypoints);

}  // namespace prehend
