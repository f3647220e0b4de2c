// Planning of a collision-free path of the arm from one posture to another. The only files that
// include OMPL (Sucan, Moll and Kavraki 2012, The Open Motion Planning Library) are these two.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "sim/base/named_enum.h"
#include "sim/base/run_context.h"
#include "sim/base/settings.h"
#include "sim/robot/dof_values.h"
#include "sim/scene/ids.h"
#include "sim/scene/reach/reach_options.h"

namespace prehend {

struct CompiledArm;

// The sampling-based planner that is used.
enum class PathPlanner {
  rrt_connect,  // two trees that grow towards each other (Kuffner and LaValle 2000)
  roadmap,      // lazy probabilistic roadmap (Bohlin and Kavraki 2000)
  rrt_star,     // asymptotically optimal: uses all its iterations to shorten the path (Karaman and
                // Frazzoli 2011)
};

// The planner's name on the command line and in files: "rrt_connect", "roadmap" or "rrt_star".
constexpr auto enum_names(PathPlanner /*of*/) {
  return std::to_array<std::string_view>({"rrt_connect", "roadmap", "rrt_star"});
}

struct TransferOptions {
  static constexpr AboutSettings kAbout{"TransferOptions",
                                        "How an arm's way to the pre-grasp is searched for."};
  PathPlanner planner = PathPlanner::rrt_connect;
  // There is no time limit, because the result would then depend on the speed of the machine.
  int max_iterations = 3000;
  int simplify_steps = 100;
  double corner_deviation = 0.2;
  std::uint64_t seed = 1;
  MotionCheckOptions motion;
};

template <SettingsOf<TransferOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [planner, max_iterations, simplify_steps, corner_deviation, seed, motion] = options;
  visit("planner", planner, "The sampling-based planner: fast ways, many ways or short ways.");
  visit("max_iterations", max_iterations, kCountAbove0, "",
        "Iterations after which a search ends; rrt_connect searches up to 24 times.");
  visit("simplify_steps", simplify_steps, kCount, "",
        "Attempts to shorten the path that was found.");
  visit("corner_deviation", corner_deviation, kDistance, "m",
        "How far the motion may pass from its corners, as the farthest that any point of the arm "
        "moves from where it is at the corner; 0: it stops at each of them.");
  visit.unlisted("seed", seed, kAtLeast0, "", "Of the search.");
  visit({"motion", ""}, motion, "How motions are proven free of collision.");
}

// What is asked of plan_transfer: two postures of the arm, and the posture in which it carries the
// hand.
struct Transfer {
  DofValues from;                   // all degrees of freedom of the platform [rad or m]
  DofValues to;                     // as `from`
  std::vector<double> hand_joints;  // the hand's joints, constant along the path [rad or m]
};

// Waypoints joined by straight lines in joint space: the first is `from`, the last `to`, all
// degrees of freedom of the platform each. None where no path was found.
struct TransferPath {
  std::vector<DofValues> waypoints;
  // The pair that blocked most of the motions that the search tried; none where it tried none.
  std::optional<ArmPair> bottleneck;
};

// Every line of the path is proven free of collision (first_blocked). The same seed gives the same
// path, on any thread. Throws Cancelled.
TransferPath plan_transfer(const CompiledArm& arm, const Transfer& transfer,
                           const TransferOptions& options = {}, const RunContext& context = {});

}  // namespace prehend
