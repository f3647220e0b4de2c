// One seed for a whole run.
#pragma once

#include <cstdint>

namespace prehend {

// The seed of a random generator inside a run with the given seed: the same run gives the same
// generators, on any number of threads. `item` tells generators apart that serve one purpose side
// by side, such as those of the paths to different grasps. Generators of different purposes may
// start from the same number: they draw different things from it, so that nothing is correlated.
constexpr std::uint64_t derived_seed(std::uint64_t run, std::uint64_t item = 0) {
  return run + item;
}

}  // namespace prehend
