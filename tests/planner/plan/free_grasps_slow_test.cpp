// The best grasps of plans on objects that are free to move.
#include <gtest/gtest.h>

#include "planner/plan/free_grasps.h"
#include "planner/plan/plan.h"
#include "sim/motion/dynamic_grasp/scene_world.h"
#include "sim/trial/close_dynamic.h"
#include "tests/support/library_scenes.h"

namespace prehend {
namespace {

PlanOptions few_trials() {
  PlanOptions options;
  options.search.trials = 100;
  options.rank.top = 4;
  options.volumes = false;
  return options;
}

// Those that keep it come first, by the epsilon where it ends.
TEST(FreeGrasps, AreRankedByWhereTheObjectEnds) {
  const CompiledScene scene = test::compiled_library_scene("mug");
  const PlanResult result = plan(scene, few_trials());
  ASSERT_EQ(result.grasps.size(), 4U);
  double last = 1.0;
  for (const ScoredGrasp& grasp : result.grasps) {
    ASSERT_TRUE(grasp.free);
    EXPECT_TRUE(keeps_object(scene, *grasp.free));
    EXPECT_LE(grasp.free->epsilon.lower, last);
    last = grasp.free->epsilon.lower;
    // The trial is that of an object that stands still.
    EXPECT_FALSE(grasp.trial.X_OC);
    EXPECT_TRUE(grasp.free->X_OC);
  }
}

TEST(FreeGrasps, AreTheSameOnAnyNumberOfThreads) {
  const CompiledScene scene = test::compiled_library_scene("mug");
  const PlanResult one = plan(scene, few_trials(), {1});
  const PlanResult three = plan(scene, few_trials(), {3});
  ASSERT_EQ(one.grasps.size(), three.grasps.size());
  for (std::size_t i = 0; i < one.grasps.size(); ++i) {
    EXPECT_EQ(one.grasps[i].tried, three.grasps[i].tried);
    EXPECT_EQ(one.grasps[i].free->X_OC->matrix(), three.grasps[i].free->X_OC->matrix());
    EXPECT_EQ(one.grasps[i].free->joints, three.grasps[i].free->joints);
  }
}

// Of the grasps of a mug from above, some squeeze it out of the fingers: they are left out, and
// counted under what became of it.
TEST(FreeGrasps, LeaveOutWhatLosesTheObject) {
  const CompiledScene scene = test::compiled_library_scene("mug_on_table");
  PlanOptions options = few_trials();
  options.free_closing = 0;
  options.search.trials = 400;
  options.rank.top = 24;
  PlanResult result = plan(scene, options);
  const PlanResult before = result;
  options.free_closing = 12;
  options.rank.pool = 2.0;
  free_grasps(scene, options, {}, result);
  const std::size_t lost = before.grasps.size() - result.grasps.size();
  ASSERT_GT(lost, 0U);
  EXPECT_EQ(before.outcomes[Outcome::stable] - result.outcomes[Outcome::stable],
            static_cast<int>(lost));
  for (const ScoredGrasp& grasp : result.grasps) {
    EXPECT_TRUE(!grasp.free || keeps_object(scene, *grasp.free));
  }
}

// Some of these are held firmly by another strategy of the hand, and only by that.
TEST(FreeGrasps, CloseByAnotherStrategyWhereAllAtOnceDoesNotHoldFirmly) {
  const CompiledScene scene = test::compiled_library_scene("cluttered_table");
  PlanOptions options = few_trials();
  options.free_closing = 0;
  options.search.trials = 400;
  options.rank.top = 24;
  PlanResult result = plan(scene, options);
  options.free_closing = 12;
  options.rank.pool = 2.0;
  free_grasps(scene, options, {}, result);
  const auto hand = hand_model(scene);
  const auto is_firm = [&](const Trial& free) {
    return free.outcome == Outcome::stable && object_moved(scene, free) < 0.02;
  };
  int others = 0;
  for (const ScoredGrasp& grasp : result.grasps) {
    if (!grasp.candidate.strategy) continue;
    ++others;
    ASSERT_TRUE(grasp.free && is_firm(*grasp.free));
    Candidate at_once = grasp.candidate;
    at_once.strategy.reset();
    const Trial lost = closed_freely(scene, hand, at_once, grasp.trial, options.trial);
    EXPECT_FALSE(is_firm(lost));
  }
  EXPECT_GT(others, 0);
}

TEST(FreeGrasps, StayAsTheyAreWhenCancelled) {
  const CompiledScene scene = test::compiled_library_scene("mug");
  PlanOptions options = few_trials();
  options.free_closing = 0;
  PlanResult result = plan(scene, options);
  const PlanResult before = result;
  Cancellation cancellation;
  cancellation.request();
  free_grasps(scene, options, {1, cancellation}, result);
  EXPECT_EQ(result.status, PlanStatus::cancelled);
  ASSERT_EQ(result.grasps.size(), before.grasps.size());
  for (std::size_t i = 0; i < before.grasps.size(); ++i) {
    EXPECT_EQ(result.grasps[i].tried, before.grasps[i].tried);
    EXPECT_FALSE(result.grasps[i].free);
  }
}

}  // namespace
}  // namespace prehend
