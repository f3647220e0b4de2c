#include "benchmarks/report/power_law.h"

#include <cmath>

#include <gtest/gtest.h>

#include "benchmarks/report/knee.h"

namespace prehend::bench {
namespace {

TEST(PowerLaw, FindsExponentAndFactor) {
  for (const double exponent : {-1.0, 0.0, 0.5, 1.0, 3.0}) {
    std::vector<DataPoint> points;
    for (const double x : {1.0, 8.0, 30.0, 1e3, 1e6}) {
      points.push_back({x, 2.5 * std::pow(x, exponent)});
    }
    const auto law = fit_power_law(points);
    ASSERT_TRUE(law);
    // Sums of a few logarithms: rounding only.
    EXPECT_NEAR(law->exponent, exponent, 1e-12);
    EXPECT_NEAR(law->factor, 2.5, 1e-11);
    EXPECT_NEAR(law->r_squared, 1.0, 1e-12);
    EXPECT_NEAR(law->at(8.0), points[1].y, 1e-10 * points[1].y);
  }
}

// By hand: log2 x = 0, 1, 2 and log2 y = 0, 2, 1; the slope is 1/2, the mean 1, R² 1/4.
TEST(PowerLaw, IsTheLeastSquaresLineOfTheLogarithms) {
  const auto law = fit_power_law({{1.0, 1.0}, {2.0, 4.0}, {4.0, 2.0}});
  ASSERT_TRUE(law);
  EXPECT_NEAR(law->exponent, 0.5, 1e-12);
  EXPECT_NEAR(law->factor, std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(law->r_squared, 0.25, 1e-12);
}

TEST(PowerLaw, LeavesOutWhatHasNoLogarithm) {
  const auto law = fit_power_law({{0.0, 5.0}, {1.0, 3.0}, {2.0, 0.0}, {10.0, 30.0}});
  ASSERT_TRUE(law);
  EXPECT_NEAR(law->exponent, 1.0, 1e-12);
}

TEST(PowerLaw, NeedsTwoSizes) {
  EXPECT_FALSE(fit_power_law({}));
  EXPECT_FALSE(fit_power_law({{3.0, 1.0}}));
  EXPECT_FALSE(fit_power_law({{3.0, 1.0}, {3.0, 2.0}}));
  EXPECT_FALSE(fit_power_law({{0.0, 1.0}, {3.0, 2.0}}));
}

TEST(Knee, IsFarthestAboveTheLine) {
  EXPECT_EQ(knee_of({{0.0, 0.0}, {1.0, 0.8}, {2.0, 0.9}, {10.0, 1.0}}), 1U);
  EXPECT_EQ(knee_of({{1.0, 0.0}, {2.0, 0.5}, {3.0, 1.0}, {6.0, 1.05}, {50.0, 1.2}}), 2U);
}

TEST(Knee, ThereMayBeNone) {
  EXPECT_FALSE(knee_of({{0.0, 0.0}, {1.0, 1.0}}));
  EXPECT_FALSE(knee_of({{0.0, 0.0}, {1.0, 0.5}, {2.0, 1.0}}));  // straight
  EXPECT_FALSE(knee_of({{0.0, 0.0}, {1.0, 0.1}, {2.0, 1.0}}));  // late gain
  EXPECT_FALSE(knee_of({{0.0, 1.0}, {1.0, 0.5}, {2.0, 0.0}}));  // loss
  EXPECT_FALSE(knee_of({{0.0, 0.2}, {1.0, 0.2}, {2.0, 0.2}}));  // nothing gained
}

}  // namespace
}  // namespace prehend::bench
