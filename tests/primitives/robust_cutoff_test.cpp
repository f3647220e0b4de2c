// The cutoff of the robust fits, which is computed without the median where counting is enough.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "primitives/fit.h"
#include "sim/base/random.h"

namespace prehend {
namespace {

double from_the_median(const Eigen::ArrayXd& residuals, double outlier) {
  Eigen::ArrayXd sizes = residuals.abs();
  std::sort(sizes.begin(), sizes.end());
  const double median = sizes[std::lround(0.5 * static_cast<double>(sizes.size() - 1))];
  return std::clamp(4.685 * 1.4826 * median, 0.4 * outlier, 2.0 * std::max(outlier, median));
}

TEST(RobustCutoff, FollowsTheMedianOfResidualsOfAnySize) {
  Random random(1);
  const FitOptions options{.outlier = 0.05};
  for (int count = 1; count <= 100; ++count) {
    for (double size = 1e-4; size < 10.0; size *= 1.7) {
      Eigen::ArrayXd residuals(count);
      for (double& r : residuals) r = random.uniform(-size, size);
      EXPECT_DOUBLE_EQ(robust_cutoff(residuals, options), from_the_median(residuals, 0.05))
          << count << " residuals of up to " << size;
    }
  }
}

TEST(RobustCutoff, OfNoResidualsIsTheLowest) {
  EXPECT_DOUBLE_EQ(robust_cutoff(Eigen::ArrayXd(), {.outlier = 0.05}), 0.02);
}

}  // namespace
}  // namespace prehend
