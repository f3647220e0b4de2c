#include "planner/show/validation/bootstrap.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/planner/show/validation/random_executions.h"

namespace prehend::test {
namespace {

RankingEstimates estimates_of(const RandomExecutions& random, const BootstrapOptions& options) {
  const std::vector<Ranking> rankings = {Ranking(random.scores, random.labels)};
  return bootstrap_auc(rankings, random.labels, 0, options);
}

TEST(Bootstrap, IntervalsContainTheTrueValueAboutAsOftenAsTheySay) {
  const ExecutionsWanted wanted{.executions = 240, .objects = 40, .separation = 1.0};
  const double truth = 0.5 * std::erfc(-1.0 / 2.0);  // Phi(1 / sqrt 2)
  int contained = 0;
  constexpr int kSets = 200;
  for (std::uint64_t seed = 1; seed <= kSets; ++seed) {
    const RankingEstimates estimates =
        estimates_of(random_executions(wanted, seed), {.resamples = 300, .seed = seed});
    const Interval interval = *estimates.auc[0].interval;
    contained += interval.lower <= truth && truth <= interval.upper ? 1 : 0;
  }
  // 190 of 200 are expected, give or take 3 for a perfect interval; percentile intervals of 40
  // groups are known to contain the value a little too seldom.
  EXPECT_GE(contained, 178);
  EXPECT_LE(contained, 198);
}

// Executions of a group that are all the same tell no more than one of them.
TEST(Bootstrap, GroupsAreDrawnWhole) {
  const RandomExecutions once = random_executions({.executions = 30, .objects = 30}, 3);
  RandomExecutions often;
  for (int copy = 0; copy < 5; ++copy) {
    often.scores.insert(often.scores.end(), once.scores.begin(), once.scores.end());
    often.labels.insert(often.labels.end(), once.labels.begin(), once.labels.end());
  }
  const Interval of_once = *estimates_of(once, {}).auc[0].interval;
  const Interval of_often = *estimates_of(often, {}).auc[0].interval;
  EXPECT_NEAR(of_often.lower, of_once.lower, 1e-12);
  EXPECT_NEAR(of_often.upper, of_once.upper, 1e-12);
  const Interval one_by_one = *estimates_of(often, {.grouping = Grouping::each}).auc[0].interval;
  EXPECT_LT(one_by_one.upper - one_by_one.lower, 0.7 * (of_once.upper - of_once.lower));
}

TEST(Bootstrap, ObjectsAndSessionsTogetherAreLessCertainThanOneOfThem) {
  const RandomExecutions random =
      random_executions({.executions = 300, .objects = 10, .sessions = 6}, 4);
  const auto width = [&](Grouping grouping) {
    const Interval interval = *estimates_of(random, {.grouping = grouping}).auc[0].interval;
    return interval.upper - interval.lower;
  };
  EXPECT_GT(width(Grouping::both), width(Grouping::object));
  EXPECT_GT(width(Grouping::both), width(Grouping::session));
  EXPECT_EQ(estimates_of(random, {.grouping = Grouping::both}).groups, 16);
}

TEST(Bootstrap, DifferencesAreOfTheSameResamples) {
  const RandomExecutions random = random_executions({.executions = 100}, 7);
  std::vector<double> doubled;
  for (const double score : random.scores) doubled.push_back(2.0 * score);
  const std::vector<Ranking> rankings = {Ranking(random.scores, random.labels),
                                         Ranking(doubled, random.labels)};
  const RankingEstimates estimates = bootstrap_auc(rankings, random.labels, 0, {});
  // The same order of executions: no resample tells the two apart.
  for (const Estimate& difference : estimates.difference) {
    EXPECT_EQ(difference.value, 0.0);
    EXPECT_EQ(difference.interval->lower, 0.0);
    EXPECT_EQ(difference.interval->upper, 0.0);
  }
  EXPECT_GT(estimates.auc[1].interval->upper, estimates.auc[1].interval->lower);
}

TEST(Bootstrap, TheSameSeedGivesTheSameBits) {
  const RandomExecutions random = random_executions({.executions = 100}, 8);
  const Interval first = *estimates_of(random, {.seed = 9}).auc[0].interval;
  const Interval again = *estimates_of(random, {.seed = 9}).auc[0].interval;
  const Interval other = *estimates_of(random, {.seed = 10}).auc[0].interval;
  EXPECT_EQ(first.lower, again.lower);
  EXPECT_EQ(first.upper, again.upper);
  EXPECT_NE(first.lower, other.lower);
}

TEST(Bootstrap, OneGroupHasNoInterval) {
  const RandomExecutions random = random_executions({.executions = 50, .objects = 1}, 8);
  const RankingEstimates estimates = estimates_of(random, {});
  EXPECT_TRUE(estimates.auc[0].value);
  EXPECT_FALSE(estimates.auc[0].interval);
  EXPECT_EQ(estimates.groups, 1);
}

// Two objects of one outcome each: half of the resamples draw one of them twice.
TEST(Bootstrap, ResamplesOfOneOutcomeAreCounted) {
  RandomExecutions random;
  for (int i = 0; i < 10; ++i) {
    random.scores.push_back(i);
    random.labels.push_back({i >= 5, 1, i >= 5 ? 1 : 0});
  }
  const RankingEstimates estimates = estimates_of(random, {.resamples = 1000});
  EXPECT_NEAR(estimates.undefined, 500, 80);  // five standard deviations
}

TEST(Bootstrap, StopsWhenCancelled) {
  const RandomExecutions random = random_executions({.executions = 50}, 8);
  const std::vector<Ranking> rankings = {Ranking(random.scores, random.labels)};
  const RunContext context;
  context.cancellation.request();
  EXPECT_THROW(bootstrap_auc(rankings, random.labels, 0, {}, context), Cancelled);
}

TEST(Bootstrap, DrawsObjectsWhereThereAreSeveralElseSessions) {
  std::vector<Label> labels(4);
  EXPECT_EQ(natural_grouping(labels), Grouping::each);
  labels[1].session = 1;
  EXPECT_EQ(natural_grouping(labels), Grouping::session);
  labels[2].object = 3;
  EXPECT_EQ(natural_grouping(labels), Grouping::object);
}

TEST(Bootstrap, GroupingsHaveNames) {
  for (const Grouping grouping : kAll<Grouping>) {
    EXPECT_EQ(value_named<Grouping>(name_of(grouping)), grouping);
  }
  EXPECT_EQ(value_named<Grouping>(""), std::nullopt);
  EXPECT_EQ(value_named<Grouping>("objects"), std::nullopt);
}

}  // namespace
}  // namespace prehend::test
