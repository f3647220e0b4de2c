#include "sim/quality/wrench_size.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "sim/base/input_error.h"
#include "sim/quality/epsilon.h"
#include "sim/quality/wrench_hull.h"
#include "tests/support/grasp_families.h"

namespace prehend::test {
namespace {

Wrenches cube() { return contact_wrenches(cube_grasp(0.5), {}); }

TEST(WrenchSize, OrdinarySizesStay) {
  EXPECT_EQ(excess_exponent(Wrenches(6, 0)), 0);
  EXPECT_EQ(excess_exponent(Wrenches::Zero(6, 3)), 0);
  for (const double size : {1e-45, 1e-12, 1.0, 1e12, 1e45}) {
    EXPECT_EQ(excess_exponent(size * cube()), 0) << size;
  }
}

TEST(WrenchSize, ExtremeSizesComeToOne) {
  for (const double size : {1e-320, 1e-300, 1e-46, 1e46, 1e300}) {
    const Wrenches wrenches = size * cube();
    const Wrenches scaled = times_power_of_two(wrenches, -excess_exponent(wrenches));
    EXPECT_GE(scaled.cwiseAbs().maxCoeff(), 0.5) << size;
    EXPECT_LT(scaled.cwiseAbs().maxCoeff(), 1.0) << size;
  }
}

TEST(WrenchSize, ExtremeSizesHaveTheSameQuality) {
  const EpsilonBracket bracket = epsilon_l1(cube());
  const WrenchHull hull = wrench_hull(cube());
  for (const int exponent : {-1000, -600, -200, 200, 600, 1000}) {
    const Wrenches wrenches = times_power_of_two(cube(), exponent);
    const EpsilonBracket extreme = epsilon_l1(wrenches);
    EXPECT_EQ(extreme.status, EpsilonStatus::converged) << exponent;
    // The same digits: powers of two do not round. The first column decides ties in both.
    EXPECT_NEAR(std::ldexp(extreme.lower, -exponent), bracket.lower, 1e-13) << exponent;
    EXPECT_NEAR(std::ldexp(extreme.upper, -exponent), bracket.upper, 1e-13) << exponent;
    EXPECT_NEAR(times_power_of_two(extreme.weakest, -exponent).norm(), bracket.upper, 1e-13);
    const WrenchHull large = wrench_hull(wrenches);
    EXPECT_EQ(large.force_closure(), hull.force_closure()) << exponent;
    EXPECT_NEAR(std::ldexp(large.min_offset, -exponent), hull.min_offset, 1e-13) << exponent;
    EXPECT_EQ(large.volume, exponent > 0 ? HUGE_VAL : 0.0) << exponent;
    EXPECT_TRUE(large.weakest.allFinite()) << exponent;
  }
}

// Sizes that are not scaled: powers of two do not round.
TEST(WrenchSize, OrdinarySizesHaveTheSameDigits) {
  for (const NamedGrasp& grasp : grasp_families(61, 1)) {
    const Wrenches wrenches = contact_wrenches(grasp.contacts, {}, grasp.edges);
    const EpsilonBracket bracket = epsilon_l1(wrenches);
    for (const int exponent : {-140, -60, 60, 140}) {
      const EpsilonBracket other = epsilon_l1(times_power_of_two(wrenches, exponent));
      EXPECT_EQ(std::ldexp(other.lower, -exponent), bracket.lower) << grasp.name << exponent;
      EXPECT_EQ(std::ldexp(other.upper, -exponent), bracket.upper) << grasp.name << exponent;
    }
  }
}

TEST(WrenchSize, CutoffIsOfTheSameSize) {
  const Wrenches wrenches = times_power_of_two(cube(), 600);
  const double upper = epsilon_l1(wrenches).upper;
  EXPECT_EQ(epsilon_l1(wrenches, {.cutoff = 0.99 * upper}).status, EpsilonStatus::converged);
  EXPECT_LT(epsilon_l1(wrenches, {.cutoff = 2.0 * upper}).upper, 2.0 * upper);
}

TEST(WrenchSize, NotFiniteIsStillRefused) {
  for (const double bad : {HUGE_VAL, -HUGE_VAL, std::numeric_limits<double>::quiet_NaN()}) {
    Wrenches wrenches = times_power_of_two(cube(), 600);
    wrenches(2, 5) = bad;
    EXPECT_THROW(epsilon_l1(wrenches), InputError);
    EXPECT_THROW(wrench_hull(wrenches), InputError);
  }
}

}  // namespace
}  // namespace prehend::test
