// Which grasps are best, and which are the same grasp.
#pragma once

#include <vector>

#include "sim/base/settings.h"
#include "sim/trial/trial.h"

namespace prehend {

struct RankOptions {
  int top = 10;  // grasps to return (>= 1)
  // Grasps whose hands are closer than both of these are one; the better stands for it.
  double same_distance = 0.01;  // m
  double same_angle = 0.35;     // rad
  // So are grasps that touch at the same points: a two-finger hand turned by half a turn.
  double same_contact = 1e-3;  // m
};

template <SettingsOf<RankOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [top, same_distance, same_angle, same_contact] = options;
  visit("top", top);
  visit("same_distance", same_distance);
  visit("same_angle", same_angle);
  visit("same_contact", same_contact);
}

// Indices of the stable trials, largest epsilon first (equal epsilon: smaller index first), without
// those that are near-identical to a better one, at most `top`.
std::vector<std::size_t> rank(const std::vector<Trial>& trials, const RankOptions& options);

}  // namespace prehend
