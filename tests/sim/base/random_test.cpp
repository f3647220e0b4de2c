#include "sim/base/random.h"

#include <set>

#include <gtest/gtest.h>

namespace prehend {
namespace {

TEST(DerivedSeed, OfTheFirstItemIsThatOfTheRun) {
  for (const std::uint64_t run : {0U, 1U, 42U}) EXPECT_EQ(derived_seed(run), run);
}

// SplitMix64 begins at seed 0 with these numbers: it mixes multiples of the golden ratio's bits.
TEST(DerivedSeed, MixesAsSplitMix64Does) {
  constexpr std::uint64_t kGolden = 0x9E3779B97F4A7C15U;
  EXPECT_EQ(derived_seed(0, kGolden), 0xE220A8397B1DCDAFU);
  EXPECT_EQ(derived_seed(0, 2 * kGolden), 0x6E789E6AA1B965F4U);
}

TEST(DerivedSeed, IsNotSharedByRunsWithNeighbouringSeeds) {
  std::set<std::uint64_t> seeds;
  for (std::uint64_t run = 0; run < 100; ++run) {
    for (std::uint64_t item = 0; item < 100; ++item) seeds.insert(derived_seed(run, item));
  }
  EXPECT_EQ(seeds.size(), 10'000U);
}

}  // namespace
}  // namespace prehend
