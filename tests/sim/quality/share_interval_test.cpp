#include "sim/quality/share_interval.h"

#include <cmath>

#include <gtest/gtest.h>

namespace prehend {
namespace {

// Wilson's interval consists of the shares p that |p - held / count| <= quantile sqrt(p (1 - p) /
// count) does not rule out: both ends fulfil it with equality.
TEST(ShareInterval, EndsWhereTheScoreTestDoes) {
  for (const double quantile : {kQuantile90, kQuantile95}) {
    for (const int count : {1, 10, 500}) {
      for (const int held : {0, count / 2, count}) {
        const Interval interval = share_interval(held, count, quantile);
        const double share = static_cast<double>(held) / count;
        for (const double end : {interval.lower, interval.upper}) {
          const double limit = quantile * std::sqrt(end * (1.0 - end) / count);
          EXPECT_NEAR(std::abs(end - share), limit, 1e-7) << held << " of " << count;
        }
        EXPECT_LE(interval.lower, share + 1e-15);  // rounding
        EXPECT_GE(interval.upper, share - 1e-15);
      }
    }
  }
}

TEST(ShareInterval, WithoutTriesIsEverything) {
  EXPECT_EQ(share_interval(0, 0, kQuantile95).lower, 0.0);
  EXPECT_EQ(share_interval(0, 0, kQuantile95).upper, 1.0);
}

}  // namespace
}  // namespace prehend
