// A way of the arm from one posture to another, around everything. The only place that knows OMPL.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "sim/base/run_context.h"
#include "sim/reach/motion_check.h"
#include "sim/robot/inverse_kinematics.h"

namespace prehend {

enum class PathPlanner {
  rrt_connect,  // two trees that grow towards each other (Kuffner and LaValle 2000)
  roadmap,      // lazy probabilistic roadmap (Bohlin and Kavraki 2000)
  rrt_star,     // shorter the longer it may take (Karaman and Frazzoli 2011)
};

// "rrt_connect", ...
std::string_view path_planner_name(PathPlanner planner);
std::optional<PathPlanner> path_planner_named(std::string_view name);

struct TransferOptions {
  PathPlanner planner = PathPlanner::rrt_connect;
  int max_iterations = 3000;  // of the planner; a time limit would not repeat
  int simplify_steps = 100;   // tries to cut a corner short
  std::uint64_t seed = 1;
  MotionCheckOptions motion;
};

struct Transfer {
  DofValues from;
  DofValues to;
  std::vector<double> hand_joints;  // as they are all the way
};

// Waypoints from `from` to `to`, joined by straight lines that are proven free of collision
// (first_blocked); empty when none was found. The same for the same seed, on any thread.
// Throws Cancelled.
std::vector<DofValues> plan_transfer(const CompiledArm& arm, const Transfer& transfer,
                                     const TransferOptions& options = {},
                                     const RunContext& context = {});

}  // namespace prehend
