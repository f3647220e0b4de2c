// Two hands that hold one object together: pairs of grasps, each planned for one of the hands.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "planner/plan/plan_result.h"
#include "planner/plan/together/shared_paths.h"
#include "sim/base/settings.h"
#include "sim/manipulation/lift_together.h"

namespace prehend {

struct TogetherOptions {
  static constexpr AboutSettings kAbout{"TogetherOptions", "How grasps of two hands are paired."};
  int top = 3;
  int pool = 24;
  int lifts = 12;
  double apart = 2e-3;
  SharedLiftOptions lift;
  // Set: paths of both arms, and pairs without are passed over; both scenes need an arm.
  std::optional<GraspPathOptions> paths;
};

template <SettingsOf<TogetherOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [top, pool, lifts, apart, lift, paths] = options;
  visit("top", top, kCountAbove0, "", "Most pairs that are returned.");
  visit("pool", pool, kCountAbove0, "",
        "So many grasps of each hand are paired: the best, and those that are farthest from them.");
  visit("lifts", lifts, kCount, "",
        "So many pairs, the best ones, are lifted in simulation at most, until there are enough.");
  visit("apart", apart, kDistance, "m", "The least gap between the two robots in their grasps.");
  visit("lift", lift, "How the hands lift.");
  visit.unlisted("paths", paths, "Set: paths of both arms are planned.");
}

// A plan of one of the hands, in its own scene of the object.
struct HandPlan {
  const CompiledScene& scene;
  const PlanResult& result;
};

// A pair of grasps.
struct SharedGrasp {
  std::array<std::size_t, 2> grasps = {};  // index into PlanResult::grasps of each plan
  EpsilonBracket epsilon;                  // of the contacts of both
  // How many times the weight the drives hold (LoadCase::strength): of both, and of each alone.
  double strength = 0.0;
  std::array<double, 2> alone = {};
  SharedLift lift = {};
  std::optional<SharedPaths> paths = {};
};

struct TogetherResult {
  std::vector<SharedGrasp> grasps;  // that lift the object, by epsilon, best first
  int pairs = 0;                    // that were looked at
  int apart = 0;                    // of them, whose robots do not meet
  int bear = 0;                     // of these, that bear the weight
  int tried = 0;                    // of these, that were lifted in simulation,
  int lifted = 0;                   // and kept the object
};

// What hold_together asks of the two scenes, to be asked before they are planned. Throws InputError
// where they have not the same object at the same place, where a hand has suction cups, and where
// paths are wanted without an arm.
void require_pair(const CompiledScene& first, const CompiledScene& second, bool paths);

// Pairs the grasps of two hands whose robots do not meet and whose drives bear the weight together,
// has the best of them lift the object, and plans the paths of those that do. Epsilon is that of
// Ferrari and Canny over the contacts of both hands. The same on any number of threads. Throws as
// require_pair, and Cancelled.
TogetherResult hold_together(const std::array<HandPlan, 2>& plans,
                             const TogetherOptions& options = {}, const RunContext& context = {});

}  // namespace prehend
