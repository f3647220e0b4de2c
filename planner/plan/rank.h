// Ranking of grasps by quality, without near-identical ones.
#pragma once

#include <functional>
#include <vector>

#include "sim/base/named_enum.h"
#include "sim/base/settings.h"
#include "sim/trial/trial.h"

namespace prehend {

struct Hand;

// What comes first among the grasps that are returned.
enum class RankBy {
  epsilon,      // the larger one
  probability,  // those that hold in more of the trials with errors (perturb_grasps.h)
  success       // those that lift the object more probably (success.h)
};

constexpr auto enum_names(RankBy /*of*/) {
  return std::to_array<std::string_view>({"epsilon", "probability", "success"});
}

struct RankOptions {
  static constexpr AboutSettings kAbout{"RankOptions",
                                        "How many grasps are returned, in which order, and which "
                                        "count as the same."};
  int top = 10;
  RankBy by = RankBy::epsilon;
  double pool = 3.0;
  // Two grasps are the same when both of these are small, and only the better one is returned.
  double same_distance = 0.01;
  double same_angle = 0.35;
  // A two-finger hand turned by half a turn touches at the same points.
  double same_contact = 1e-3;
};

template <SettingsOf<RankOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [top, by, pool, same_distance, same_angle, same_contact] = options;
  visit("top", top, kCountAbove0, "", "Most grasps that are returned.");
  visit.unlisted("by", by,
                 "What comes first; anything but epsilon takes the trials with errors "
                 "(PlanOptions.robustness).");
  visit(
      "pool", pool, kCountAbove0, "",
      "At most so many times the grasps that are wanted are closed on a free object, or tried with "
      "errors where these rank them.");
  visit(
      "same_distance", same_distance, kDistance, "m",
      "Grasps whose hands differ by no more than this and `same_angle` are the same; so are those "
      "of a hand and of the same hand half a turn about its approach, where contacts and normals "
      "differ by at most twice as much.");
  visit("same_angle", same_angle, kAngle, "rad", "See `same_distance`.");
  visit("same_contact", same_contact, kDistance, "m",
        "So are grasps of which each contact is within this distance of one of the other.");
}

// Indices of stable trials: those that touch preferred regions only before all others, then the
// largest lower bound of epsilon first (equal epsilon: smaller index first), without those that are
// the same as a better one; at most `top`. With `wanted`, only of trials whose index it accepts.
// With `hand`, one that has been turned by half a turn about its approach and touches where it did
// before counts as the same: its fingers have changed places.
std::vector<std::size_t> rank(const std::vector<Trial>& trials, const RankOptions& options,
                              const std::function<bool(std::size_t)>& wanted = {},
                              const Hand* hand = nullptr);

}  // namespace prehend
