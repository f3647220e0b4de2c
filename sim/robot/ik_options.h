// Options of the inverse kinematics.
#pragma once

#include <cstdint>

#include "sim/base/settings.h"

namespace prehend {

// Settings of the inverse kinematics.
struct IkOptions {
  double position_tolerance = 1e-9;  // m
  double angle_tolerance = 1e-9;     // rad
  int max_iterations = 80;           // from one start
  int restarts = 100;                // most random starts after the given one
  int max_solutions = 16;            // the search ends with so many solutions (>= 1)
  std::uint64_t seed = 1;            // of the random starts
};

template <SettingsOf<IkOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [position_tolerance, angle_tolerance, max_iterations, restarts, max_solutions, seed] =
      options;
  visit("position_tolerance", position_tolerance, kAbove0);
  visit("angle_tolerance", angle_tolerance, kAbove0);
  visit("max_iterations", max_iterations, kAtLeast1);
  visit("restarts", restarts, kAtLeast0);
  visit("max_solutions", max_solutions, kAtLeast1);
}

}  // namespace prehend
