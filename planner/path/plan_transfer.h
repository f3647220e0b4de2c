// A collision-free path of the arm from one posture to another. The only place that knows OMPL.
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
  // Longest edge that a tree grows at once: the farthest that any point of the arm moves on it [m].
  double longest_edge = 0.8;
  std::uint64_t seed = 1;
  MotionCheckOptions motion;
};

template <SettingsOf<TransferOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [planner, max_iterations, simplify_steps, longest_edge, seed, motion] = options;
  visit("planner", planner);
  visit("max_iterations", max_iterations);
  visit("simplify_steps", simplify_steps);
  visit("longest_edge", longest_edge);
  visit("", motion);
}

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
