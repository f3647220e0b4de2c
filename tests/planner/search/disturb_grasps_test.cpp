// Disturbed trials of all grasps of a result, and their ranking.
#include "planner/search/disturb_grasps.h"

#include <numeric>

#include <gtest/gtest.h>

#include "planner/search/accuracy.h"
#include "sim/base/input_error.h"
#include "sim/trial/success.h"
#include "tests/support/library_scenes.h"

namespace prehend {
namespace {

PlanResult planned(const CompiledScene& scene, int threads, bool robustness) {
  PlanOptions options = plan_options(Accuracy::draft);
  options.search.trials = 200;
  options.robustness = robustness;
  options.uncertainty.samples = 6;
  return plan(scene, options, {threads});
}

TEST(DisturbGrasps, AreTheSameOnAnyNumberOfThreads) {
  const CompiledScene scene = test::compiled_library_scene("mug");
  const PlanResult one = planned(scene, 1, true);
  const PlanResult three = planned(scene, 3, true);
  ASSERT_EQ(one.grasps.size(), three.grasps.size());
  ASSERT_FALSE(one.grasps.empty());
  for (std::size_t i = 0; i < one.grasps.size(); ++i) {
    const Robustness& a = one.grasps[i].robustness.value();
    const Robustness& b = three.grasps[i].robustness.value();
    EXPECT_EQ(a.samples, 6);
    EXPECT_EQ(a.held, b.held);
    EXPECT_EQ(a.epsilon_mean, b.epsilon_mean);
    EXPECT_EQ(a.epsilon_low, b.epsilon_low);
    EXPECT_EQ(a.outcomes, b.outcomes);
    EXPECT_EQ(a.spare, b.spare);
    EXPECT_EQ(a.weakest_O, b.weakest_O);
  }
}

TEST(DisturbGrasps, AreNotMadeUnlessAskedFor) {
  const CompiledScene scene = test::compiled_library_scene("mug");
  for (const ScoredGrasp& grasp : planned(scene, 2, false).grasps) {
    EXPECT_FALSE(grasp.robustness.has_value());
  }
}

// Evaluated by itself, a grasp of the plan has the same disturbed trials up to its approach, which
// an evaluation does not repeat.
TEST(DisturbGrasps, OfAnEvaluationAreMadeToo) {
  const CompiledScene scene = test::compiled_library_scene("mug");
  const PlanResult result = planned(scene, 2, true);
  EvaluateOptions options;
  options.robustness = true;
  options.uncertainty.samples = 6;
  options.volumes = 0;
  const PlanResult again = evaluate(scene, {result.grasps.front().candidate}, options);
  ASSERT_EQ(again.grasps.size(), 1U);
  EXPECT_EQ(again.grasps.front().robustness.value().held,
            result.grasps.front().robustness.value().held);
}

// How probably the grasps of the mug's plan lift it, all at once.
std::vector<double> successes(const Scene& scene, const std::vector<Candidate>& grasps,
                              double errors = 1.0) {
  EvaluateOptions options;
  options.robustness = true;
  UncertaintyOptions& with = options.uncertainty;
  for (double* value : {&with.across, &with.along, &with.angle, &with.hand, &with.hand_angle,
                        &with.friction, &with.center_of_mass}) {
    *value *= errors;
  }
  options.volumes = 0;
  std::vector<double> all(grasps.size());
  for (const ScoredGrasp& grasp : evaluate(compile(scene), grasps, options).grasps) {
    all[static_cast<std::size_t>(grasp.tried)] = success_probability(grasp.robustness.value());
  }
  return all;
}

std::vector<Candidate> grasps_of_mug(const CompiledScene& mug) {
  std::vector<Candidate> grasps;
  for (const ScoredGrasp& grasp : planned(mug, 2, false).grasps) grasps.push_back(grasp.candidate);
  return grasps;
}

FrictionTable scaled_friction(const FrictionTable& table, double part) {
  FrictionTable scaled;
  for (const Material a : kMaterials) {
    for (const Material b : kMaterials) scaled.set(a, b, part * table.between(a, b));
  }
  return scaled;
}

void expect_none_larger(const std::vector<double>& less, const std::vector<double>& more) {
  for (std::size_t i = 0; i < less.size(); ++i) EXPECT_LE(less[i], more[i]) << "grasp " << i;
}

// The motions of this hand depend neither on friction nor on its efforts, so each of its samples
// can only get worse.
TEST(Success, IsNeverHigherForLessFrictionOrLessForce) {
  const CompiledScene mug = test::compiled_library_scene("mug");
  const std::vector<Candidate> grasps = grasps_of_mug(mug);
  ASSERT_GE(grasps.size(), 3U);
  std::vector<double> before = successes(mug.scene, grasps);
  for (const double part : {0.7, 0.4, 0.1}) {
    Scene slippery = mug.scene;
    slippery.friction = scaled_friction(mug.scene.friction, part);
    const std::vector<double> now = successes(slippery, grasps);
    expect_none_larger(now, before);
    before = now;
  }
  before = successes(mug.scene, grasps);
  for (const double part : {0.3, 0.05, 0.01}) {
    Scene weak = mug.scene;
    for (Joint& joint : weak.hand.joints) joint.max_effort *= part;
    const std::vector<double> now = successes(weak, grasps);
    expect_none_larger(now, before);
    before = now;
  }
  EXPECT_LT(before.front(), successes(mug.scene, grasps).front());
}

// Of one grasp an error may turn a miss into a hit; of all of them together it does not.
TEST(Success, IsLowerInTheMeanForLargerErrors) {
  const CompiledScene mug = test::compiled_library_scene("mug");
  const std::vector<Candidate> grasps = grasps_of_mug(mug);
  double before = 1.0 * static_cast<double>(grasps.size());
  for (const double errors : {0.25, 1.0, 2.0}) {
    const std::vector<double> now = successes(mug.scene, grasps, errors);
    const double sum = std::accumulate(now.begin(), now.end(), 0.0);
    EXPECT_LT(sum, before) << errors;
    before = sum;
  }
}

PlanOptions ranked_by(RankBy by, double pool) {
  PlanOptions options = plan_options(Accuracy::draft);
  options.search.trials = 200;
  options.robustness = true;
  options.uncertainty.samples = 12;
  options.volumes = false;
  options.rank.top = 4;
  options.rank.by = by;
  options.rank.pool = pool;
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
    by == RankBy::success ? rank_by_success(pool) : rank_by_probability(pool);
    const PlanResult list = plan(scene, ranked_by(by, 4.0));
    ASSERT_EQ(list.grasps.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) {
      const Robustness& robustness = list.grasps[i].robustness.value();
      EXPECT_EQ(robustness.samples, 12);
      EXPECT_EQ(list.grasps[i].trial.X_OH.matrix(), pool.grasps[i].trial.X_OH.matrix()) << i;
      EXPECT_EQ(robustness.held, pool.grasps[i].robustness->held);
      EXPECT_EQ(robustness.spare, pool.grasps[i].robustness->spare);
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
  ASSERT_EQ(result.grasps.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(result.grasps[i].tried, tried[i]);
    EXPECT_FALSE(result.grasps[i].robustness.has_value());
  }
}

ScoredGrasp grasp_with(int held, double spare, double epsilon) {
  ScoredGrasp grasp;
  Robustness robustness;
  robustness.samples = 16;
  robustness.held = held;
  robustness.spare = spare;
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
  rank_by_probability(result);
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
    grasp.robustness->outcomes[static_cast<std::size_t>(Outcome::stable)] = 16;
    grasp.robustness->strength = i == 3 ? 8.0 : 2.0;
  }
  rank_by_success(result);
  std::vector<int> order;
  for (const ScoredGrasp& grasp : result.grasps) order.push_back(grasp.tried);
  EXPECT_EQ(order, std::vector<int>({2, 1, 0, 3}));
}

}  // namespace
}  // namespace prehend
