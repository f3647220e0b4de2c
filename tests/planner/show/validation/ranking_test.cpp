#include "planner/show/validation/ranking.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "tests/planner/show/validation/random_executions.h"

namespace prehend::test {
namespace {

std::vector<Label> labels_of(const std::vector<bool>& lifted) {
  std::vector<Label> labels;
  for (const bool one : lifted) labels.push_back({one});
  return labels;
}

std::optional<double> auc_of(const std::vector<double>& scores, const std::vector<Label>& labels) {
  return Ranking(scores, labels).auc(weights_of(labels));
}

// The definition: all pairs of a lifted and a failed execution.
double auc_by_pairs(const std::vector<double>& scores, const std::vector<Label>& labels) {
  double right = 0.0;
  double all = 0.0;
  for (std::size_t a = 0; a < labels.size(); ++a) {
    for (std::size_t b = 0; b < labels.size(); ++b) {
      if (!labels[a].lifted || labels[b].lifted) continue;
      const double weight = labels[a].times * labels[b].times;
      all += weight;
      right += weight * (scores[a] > scores[b] ? 1.0 : scores[a] == scores[b] ? 0.5 : 0.0);
    }
  }
  return right / all;
}

double area_below(const std::vector<RocPoint>& roc) {
  double area = 0.0;
  for (std::size_t i = 1; i < roc.size(); ++i) {
    area += (roc[i].failed - roc[i - 1].failed) * 0.5 * (roc[i].lifted + roc[i - 1].lifted);
  }
  return area;
}

TEST(Ranking, OfSmallSetsIsKnown) {
  const auto labels = labels_of({true, true, false, false});
  EXPECT_EQ(auc_of({4, 3, 2, 1}, labels), 1.0);
  EXPECT_EQ(auc_of({1, 2, 3, 4}, labels), 0.0);
  EXPECT_EQ(auc_of({1, 1, 1, 1}, labels), 0.5);
  EXPECT_EQ(auc_of({4, 2, 3, 1}, labels), 0.75);
  EXPECT_EQ(auc_of({3, 2, 2, 1}, labels), 0.875);  // one tie of four pairs
}

TEST(Ranking, InfiniteScoresAreLargestAndTie) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(auc_of({kInfinite, kInfinite, 7.0}, labels_of({true, false, false})), 0.75);
}

TEST(Ranking, OfOneOutcomeIsNothing) {
  const auto labels = labels_of({true, true});
  const Ranking ranking(std::vector<double>{1, 2}, labels);
  EXPECT_EQ(ranking.auc(weights_of(labels)), std::nullopt);
  EXPECT_TRUE(ranking.roc(weights_of(labels)).empty());
}

TEST(Ranking, IsThatOfAllPairsAndTheAreaOfItsCurve) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const RandomExecutions random = random_executions({.executions = 80, .ties = true}, seed);
    const Ranking ranking(random.scores, random.labels);
    const std::vector<double> weights = weights_of(random.labels);
    // Sums of at most 80 numbers of about 1 each.
    EXPECT_NEAR(*ranking.auc(weights), auc_by_pairs(random.scores, random.labels), 1e-12);
    const std::vector<RocPoint> roc = ranking.roc(weights);
    EXPECT_NEAR(area_below(roc), *ranking.auc(weights), 1e-12);
    EXPECT_EQ(roc.front().lifted, 0.0);
    EXPECT_EQ(roc.back().failed, 1.0);
    EXPECT_EQ(roc.back().lifted, 1.0);
  }
}

TEST(Ranking, DependsOnTheOrderOfScoresOnly) {
  const RandomExecutions random = random_executions({.executions = 200, .ties = true}, 5);
  std::vector<double> changed;
  for (const double score : random.scores) changed.push_back(std::exp(3.0 * score) - 100.0);
  EXPECT_EQ(auc_of(changed, random.labels), auc_of(random.scores, random.labels));
  for (double& score : changed) score = -score;
  EXPECT_NEAR(*auc_of(changed, random.labels), 1.0 - *auc_of(random.scores, random.labels), 1e-12);
}

TEST(Ranking, DoesNotDependOnTheOrderOfExecutions) {
  RandomExecutions random = random_executions({.executions = 200, .ties = true}, 6);
  const double before = *auc_of(random.scores, random.labels);
  std::reverse(random.scores.begin(), random.scores.end());
  std::reverse(random.labels.begin(), random.labels.end());
  EXPECT_EQ(*auc_of(random.scores, random.labels), before);
}

TEST(Ranking, TimesCountAsSoManyEntries) {
  const std::vector<double> scores = {3, 2, 1};
  std::vector<Label> labels = labels_of({true, false, true});
  labels[0].times = 3;
  EXPECT_EQ(auc_of(scores, labels), 0.75);
  EXPECT_EQ(auc_of({3, 3, 3, 2, 1}, labels_of({true, true, true, false, true})), 0.75);
}

}  // namespace
}  // namespace prehend::test
