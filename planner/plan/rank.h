// Ranking of grasps by quality, without near-identical ones.
#pragma once

#include <vector>

#include "sim/base/settings.h"
#include "sim/trial/trial.h"

namespace prehend {

// What comes first among the grasps that are returned.
enum class RankBy {
  epsilon,      // the larger one
  probability,  // those that hold in more of the trials with errors (rank_by_probability)
  success       // those that lift the object more probably (rank_by_success)
};

// How many grasps are returned, in which order, and which count as the same.
struct RankOptions {
  int top = 10;  // largest number of grasps to return (>= 1)
  // Other than by epsilon takes the trials with errors (PlanOptions::robustness).
  RankBy by = RankBy::epsilon;
  // Where not by epsilon: so many times `top` grasps, the best by epsilon, are tried with errors
  // (>= 1).
  double pool = 3.0;
  // Two grasps whose hand poses differ by no more than both of these are the same, and only the
  // better one is returned.
  double same_distance = 0.01;  // m
  double same_angle = 0.35;     // rad
  // Two grasps are also the same when each contact of one is within this distance of a contact of
  // the other: a two-finger hand turned by half a turn touches at the same points.
  double same_contact = 1e-3;  // m
};

template <SettingsOf<RankOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [top, by, pool, same_distance, same_angle, same_contact] = options;
  visit("top", top, kAtLeast1);
  visit("pool", pool, kAtLeast1);
  visit("same_distance", same_distance, kAtLeast0);
  visit("same_angle", same_angle, kAtLeast0);
  visit("same_contact", same_contact, kAtLeast0);
}

// Indices of stable trials, largest lower bound of epsilon first (equal epsilon: smaller index
// first), without those that are the same as a better one; at most `top`.
std::vector<std::size_t> rank(const std::vector<Trial>& trials, const RankOptions& options);

}  // namespace prehend
