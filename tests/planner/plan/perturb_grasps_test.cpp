// Disturbed trials of all grasps of a result.
#include "planner/plan/perturb_grasps.h"

#include <gtest/gtest.h>

#include "planner/plan/accuracy.h"
#include "planner/plan/plan.h"
#include "sim/trial/close_dynamic.h"
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

ScoredGrasp evaluated(const CompiledScene& scene, const Candidate& candidate) {
  EvaluateOptions options;
  options.robustness = true;
  options.uncertainty.samples = 6;
  options.volumes = 0;
  return evaluate(scene, {candidate}, options).grasps.at(0);
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
    EXPECT_EQ(a.position_margin, b.position_margin);
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
  const ScoredGrasp again = evaluated(scene, result.grasps.front().candidate);
  EXPECT_EQ(again.robustness.value().held, result.grasps.front().robustness.value().held);
}

// An evaluation closes each grasp on a free object, too, and says what that came to.
TEST(DisturbGrasps, OfAnEvaluationKnowWhatBecomesOfAFreeObject) {
  const CompiledScene scene = test::compiled_library_scene("mug");
  const PlanResult result = planned(scene, 2, false);
  const ScoredGrasp grasp = evaluated(scene, result.grasps.front().candidate);
  ASSERT_TRUE(grasp.free);
  const FreeEnd& end = grasp.robustness.value().free.value();
  EXPECT_EQ(end.kept, keeps_object(scene, *grasp.free));
  EXPECT_EQ(end.epsilon, end.kept ? grasp.free->epsilon.lower : 0.0);
  EXPECT_GT(end.moved, 0.0);
}

// The palm is inside the mug: it may be elsewhere, so its errors are tried.
TEST(DisturbGrasps, OfABlockedGraspAreMadeToo) {
  const CompiledScene scene = test::compiled_library_scene("mug");
  Candidate candidate = planned(scene, 2, false).grasps.front().candidate;
  candidate.X_OH = translation(0.03 * candidate.approach_O) * candidate.X_OH;
  candidate.approach_distance = 0.0;
  const ScoredGrasp grasp = evaluated(scene, candidate);
  ASSERT_EQ(grasp.trial.outcome, Outcome::hand_blocked);
  EXPECT_FALSE(grasp.free);
  EXPECT_EQ(grasp.robustness.value().samples, 6);
}

}  // namespace
}  // namespace prehend
