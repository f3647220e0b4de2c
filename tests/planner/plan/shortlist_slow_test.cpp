// The grasps that a ranking by probability or success returns, of a larger pool.
#include <gtest/gtest.h>

#include "planner/plan/accuracy.h"
#include "planner/plan/perturb_grasps.h"
#include "planner/plan/plan.h"
#include "sim/base/input_error.h"
#include "sim/trial/success.h"
#include "tests/support/library_scenes.h"

namespace prehend {
namespace {

PlanOptions ranked_by(RankBy by, double pool) {
  PlanOptions options = plan_options(Accuracy::draft);
  options.search.trials = 200;
  options.robustness = true;
  options.uncertainty.samples = 12;
  options.volumes = false;
  options.rank.top = 4;
  options.rank.by = by;
  options.rank.pool = pool;
  options.free_closing = 0;  // what a free object changes is another test's matter
  return options;
}

// Those that are returned of a pool are those that come first when all of it are tried with all of
// their samples, except where an early sample misled.
TEST(Shortlist, IsTheTopOfThePool) {
  const CompiledScene scene = test::compiled_library_scene("mug");
  PlanOptions all = ranked_by(RankBy::epsilon, 1.0);
  all.rank.top = 16;
  PlanResult pool = plan(scene, all);
  ASSERT_EQ(pool.grasps.size(), 16U);
  for (const RankBy by : {RankBy::probability, RankBy::success}) {
    rank_by(by, pool);
    const PlanResult list = plan(scene, ranked_by(by, 4.0));
    ASSERT_EQ(list.grasps.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) {
      const Robustness& robustness = list.grasps[i].robustness.value();
      EXPECT_EQ(robustness.samples, 12);
      EXPECT_EQ(list.grasps[i].trial.X_OH.matrix(), pool.grasps[i].trial.X_OH.matrix()) << i;
      EXPECT_EQ(robustness.held, pool.grasps[i].robustness->held);
      EXPECT_EQ(robustness.position_margin, pool.grasps[i].robustness->position_margin);
      EXPECT_EQ(success_probability(robustness), success_probability(*pool.grasps[i].robustness));
    }
  }
}

TEST(Shortlist, IsTheSameOnAnyNumberOfThreads) {
  const CompiledScene scene = test::compiled_library_scene("mug");
  const PlanOptions options = ranked_by(RankBy::success, 3.0);
  const PlanResult one = plan(scene, options, {1});
  const PlanResult three = plan(scene, options, {3});
  ASSERT_EQ(one.grasps.size(), three.grasps.size());
  for (std::size_t i = 0; i < one.grasps.size(); ++i) {
    EXPECT_EQ(one.grasps[i].tried, three.grasps[i].tried);
    EXPECT_EQ(one.grasps[i].robustness->epsilons, three.grasps[i].robustness->epsilons);
  }
}

TEST(Shortlist, NeedsErrors) {
  const CompiledScene scene = test::compiled_library_scene("mug");
  PlanOptions options = ranked_by(RankBy::success, 3.0);
  options.robustness = false;
  EXPECT_THROW(plan(scene, options), InputError);
}

TEST(Shortlist, WithoutTimeIsThatOfEpsilon) {
  const CompiledScene scene = test::compiled_library_scene("mug");
  PlanResult result = plan(scene, ranked_by(RankBy::epsilon, 1.0));
  std::vector<int> tried;
  for (ScoredGrasp& grasp : result.grasps) {
    tried.push_back(grasp.tried);
    grasp.robustness.reset();
  }
  Cancellation cancellation;
  cancellation.request();
  shortlist_grasps(scene, {}, {}, 1, RankBy::success, 2, {1, cancellation}, result);
  EXPECT_EQ(result.status, PlanStatus::cancelled);
  ASSERT_EQ(result.grasps.size(), tried.size());
  for (std::size_t i = 0; i < tried.size(); ++i) {
    EXPECT_EQ(result.grasps[i].tried, tried[i]);
    EXPECT_FALSE(result.grasps[i].robustness.has_value());
  }
}

ScoredGrasp grasp_with(int held, double position_margin, double epsilon) {
  ScoredGrasp grasp;
  Robustness robustness;
  robustness.samples = 16;
  robustness.held = held;
  robustness.position_margin = position_margin;
  robustness.epsilon_mean = epsilon;
  grasp.robustness = robustness;
  return grasp;
}

// With the same epsilon, the one with 5 mm to spare comes before that with 1 mm.
TEST(RankByProbability, PrefersWhatHoldsThenWhatHasMoreToSpareThenEpsilon) {
  PlanResult result;
  ScoredGrasp untried;
  untried.tried = 4;
  result.grasps = {untried, grasp_with(12, 1e-3, 0.3), grasp_with(12, 5e-3, 0.3),
                   grasp_with(12, 1e-3, 0.4), grasp_with(13, 0.0, 0.1)};
  for (int i = 1; i < 5; ++i) result.grasps[static_cast<std::size_t>(i)].tried = i - 1;
  rank_by(RankBy::probability, result);
  std::vector<int> order;
  for (const ScoredGrasp& grasp : result.grasps) order.push_back(grasp.tried);
  EXPECT_EQ(order, std::vector<int>({3, 1, 2, 0, 4}));
}

// As many samples held, but the drives of one are stronger.
TEST(RankBySuccess, PrefersWhatLiftsMoreProbablyThenWhatHasMoreToSpare) {
  PlanResult result;
  ScoredGrasp untried;
  untried.tried = 3;
  result.grasps = {untried, grasp_with(12, 1e-3, 0.3), grasp_with(12, 5e-3, 0.3),
                   grasp_with(12, 1e-3, 0.3)};
  for (int i = 1; i < 4; ++i) {
    ScoredGrasp& grasp = result.grasps[static_cast<std::size_t>(i)];
    grasp.tried = i - 1;
    grasp.robustness->outcomes[Outcome::stable] = 16;
    grasp.robustness->strength = i == 3 ? 8.0 : 2.0;
  }
  rank_by(RankBy::success, result);
  std::vector<int> order;
  for (const ScoredGrasp& grasp : result.grasps) order.push_back(grasp.tried);
  EXPECT_EQ(order, std::vector<int>({2, 1, 0, 3}));
}

}  // namespace
}  // namespace prehend
