#include "benchmarks/suite/agreement.h"

#include <gtest/gtest.h>

namespace prehend::bench {
namespace {

TEST(Agreement, BestAreThoseThatHold) {
  EXPECT_EQ(best_of({0.1, 0.0, 0.3, 0.2, 0.3}, 3), (std::vector<std::size_t>{2, 4, 3}));
  EXPECT_EQ(best_of({0.1, 0.0}, 5), (std::vector<std::size_t>{0}));
}

TEST(Agreement, CountsTheBestThatAreKept) {
  const std::vector<double> reference = {0.5, 0.4, 0.3, 0.2, 0.1};
  EXPECT_EQ(kept_of_best(reference, reference, 2, 2), 2U);
  EXPECT_EQ(kept_of_best(reference, {0.1, 0.2, 0.3, 0.4, 0.5}, 2, 2), 0U);
  EXPECT_EQ(kept_of_best(reference, {0.1, 0.2, 0.3, 0.4, 0.5}, 2, 4), 1U);
  EXPECT_EQ(kept_of_best(reference, {0.0, 0.2, 0.0, 0.0, 0.0}, 2, 4), 1U);
}

TEST(Agreement, ErrorsAreOfGraspsThatHoldAtBoth) {
  const std::vector<double> errors = relative_errors({0.2, 0.0, 0.4, 0.5}, {0.1, 0.3, 0.5, 0.0});
  ASSERT_EQ(errors.size(), 2U);
  EXPECT_NEAR(errors[0], 50.0, 1e-12);
  EXPECT_NEAR(errors[1], 25.0, 1e-12);
  EXPECT_DOUBLE_EQ(other_verdicts({0.2, 0.0, 0.4, 0.5}, {0.1, 0.3, 0.5, 0.0}), 50.0);
  EXPECT_EQ(other_verdicts({}, {}), 0.0);
}

}  // namespace
}  // namespace prehend::bench
