// Options of the inverse kinematics.
#pragma once

#include <cstdint>

#include "sim/base/settings.h"

namespace prehend {

struct IkOptions {
  static constexpr AboutSettings kAbout{"IkOptions", "Inverse kinematics."};
  double position_tolerance = 1e-9;
  double angle_tolerance = 1e-9;
  int max_iterations = 80;
  int restarts = 100;
  int max_solutions = 16;
  std::uint64_t seed = 1;
};

template <SettingsOf<IkOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [position_tolerance, angle_tolerance, max_iterations, restarts, max_solutions, seed] =
      options;
  visit("position_tolerance", position_tolerance, kLengthAbove0, "m",
        "Largest error of a position.");
  visit("angle_tolerance", angle_tolerance, kAngleAbove0, "rad",
        "Largest error of an orientation.");
  visit("max_iterations", max_iterations, kCountAbove0, "", "Most iterations from one start.");
  visit("restarts", restarts, kCount, "", "Most random starts after the given one.");
  visit("max_solutions", max_solutions, kCountAbove0, "",
        "The search ends with so many solutions.");
  visit.unlisted("seed", seed, kAtLeast0, "", "Of the random starts.");
}

}  // namespace prehend
