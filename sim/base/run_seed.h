// All random generators of a run derive from one seed.
#pragma once

#include <cstdint>

namespace prehend {

// The seed of one of a run's random generators, from the run's seed `run`. It depends on nothing
// else, so that a run gives the same result on any number of threads. `item` distinguishes
// generators that serve the same purpose, such as the path planners of different grasps. Generators
// of different purposes may share a seed: they use the stream for different quantities.
constexpr std::uint64_t derived_seed(std::uint64_t run, std::uint64_t item = 0) {
  return run + item;
}

}  // namespace prehend
