#include "planner/show/validation/calibration.h"

#include <numeric>

#include <gtest/gtest.h>

#include "sim/base/random.h"

namespace prehend::test {
namespace {

TEST(Calibration, OfAFewExecutionsIsKnown) {
  const std::vector<double> predictions = {0.95, 0.95, 0.05, 0.5};
  std::vector<Label> labels(4);
  labels[0].lifted = labels[3].lifted = true;
  const Calibration found = calibration(predictions, labels);
  // Squares of 0.05, 0.95, 0.05 and 0.5.
  EXPECT_NEAR(found.brier, (0.0025 + 0.9025 + 0.0025 + 0.25) / 4.0, 1e-15);
  EXPECT_NEAR(found.brier_of_base_rate, 0.25, 1e-15);
  // |0.95 - 0.5| for two of four, |0.05 - 0| and |0.5 - 1| for one each.
  EXPECT_NEAR(found.expected_error, 0.5 * 0.45 + 0.25 * 0.05 + 0.25 * 0.5, 1e-15);
  ASSERT_EQ(found.bins.size(), 10U);
  EXPECT_EQ(found.bins[9].count, 2);
  EXPECT_EQ(found.bins[9].lifted, 1);
  EXPECT_EQ(found.bins[5].count, 1);
  EXPECT_EQ(found.bins[3].count, 0);
}

TEST(Calibration, BinsPartTheRangeAndOneIsInTheLast) {
  const std::vector<double> predictions = {0.0, 1.0, 0.25};
  const Calibration found = calibration(predictions, std::vector<Label>(3), 4);
  EXPECT_EQ(found.bins[0].count, 1);
  EXPECT_EQ(found.bins[1].count, 1);
  EXPECT_EQ(found.bins[3].count, 1);
  EXPECT_EQ(found.bins.front().from, 0.0);
  EXPECT_EQ(found.bins.back().to, 1.0);
}

TEST(Calibration, OfTheBaseRateHasItsBrierScoreAndNoError) {
  std::vector<Label> labels(10);
  for (std::size_t i = 0; i < 3; ++i) labels[i].lifted = true;
  const Calibration found = calibration(std::vector<double>(10, 0.3), labels);
  EXPECT_NEAR(found.brier, 0.21, 1e-15);
  EXPECT_NEAR(found.brier_of_base_rate, 0.21, 1e-15);
  EXPECT_NEAR(found.expected_error, 0.0, 1e-15);
}

TEST(Calibration, TimesCountAsSoManyEntries) {
  std::vector<Label> labels(2);
  labels[0] = {true, 3};
  const Calibration found = calibration(std::vector<double>{0.75, 0.75}, labels);
  EXPECT_EQ(found.bins[7].count, 4);
  EXPECT_NEAR(found.expected_error, 0.0, 1e-15);
  EXPECT_NEAR(found.brier, 0.1875, 1e-15);
}

// Outcomes drawn with the predicted probabilities: what is observed agrees with it, and each bin's
// interval contains its mean prediction in about 95 % of the cases.
TEST(Calibration, OfTruePredictionsIsGood) {
  Random random(11);
  std::vector<double> predictions;
  std::vector<Label> labels;
  for (int i = 0; i < 20000; ++i) {
    predictions.push_back(random.uniform());
    labels.push_back({random.uniform() < predictions.back()});
  }
  const Calibration found = calibration(predictions, labels);
  EXPECT_LT(found.expected_error, 0.02);
  EXPECT_NEAR(found.brier, 1.0 / 6.0, 0.005);  // the mean of p (1 - p)
  int contained = 0;
  for (const ReliabilityBin& bin : found.bins) {
    contained += bin.observed.lower <= bin.predicted && bin.predicted <= bin.observed.upper;
  }
  EXPECT_GE(contained, 8);
}

}  // namespace
}  // namespace prehend::test
