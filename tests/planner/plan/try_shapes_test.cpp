// Grasps that hold surely on the shapes that an object may have come first.
#include "planner/plan/try_shapes.h"

#include <limits>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "planner/plan/plan.h"
#include "sim/base/index.h"
#include "sim/shape/cloud/unseen_space.h"
#include "tests/support/depth_camera.h"
#include "tests/support/scenes.h"

namespace prehend {
namespace {

// A block whose far half is a guess: it may end 20 mm before or after.
Scene half_seen() {
  Scene scene = test::scene_with(find_robot("parallel_jaw"), make_box({0.04, 0.03, 0.08}));
  Completion completion;
  completion.seen.assign(scene.object.mesh.triangles.size(), 1);
  completion.seen[0] = 0;
  completion.thin = make_box({0.04, 0.03, 0.04});
  for (Vector3& v : completion.thin.vertices) v.z() -= 0.02;
  completion.thick = make_box({0.04, 0.03, 0.12});
  for (Vector3& v : completion.thick.vertices) v.z() += 0.02;
  scene.object.completion = completion;
  return scene;
}

PlanOptions trials_of_shapes() {
  PlanOptions options;
  options.search.trials = 120;
  options.rank.top = 8;
  options.refine.trials = 0;
  options.free_closing = 0;
  options.volumes = false;
  return options;
}

TEST(TryShapes, WhatHoldsMostSurelyComesFirst) {
  const CompiledScene scene = compile(half_seen());
  const PlanResult result = plan(scene, trials_of_shapes());
  ASSERT_FALSE(result.grasps.empty());
  EXPECT_LE(result.grasps.size(), 8U);
  double before = std::numeric_limits<double>::infinity();
  for (const ScoredGrasp& grasp : result.grasps) {
    ASSERT_TRUE(grasp.shapes);
    EXPECT_TRUE(grasp.shapes->likely);
    EXPECT_EQ(grasp.shapes->tried(), 3);
    EXPECT_LE(grasp.shapes->certainty, before);
    before = grasp.shapes->certainty;
  }
  EXPECT_EQ(result.grasps.front().shapes->held(), 3);
}

TEST(TryShapes, AGraspOfWhatMayNotBeThereDoesNotHoldOnTheThinShape) {
  Scene guessed = half_seen();
  // A finger is 20 mm wide: what it touches above 11 mm alone is no part of the thin block.
  SurfaceRegion sure;
  sure.inside = {Box{{0.2, 0.2, 0.2}}, translation({0.0, 0.0, 0.011 - 0.1})};
  guessed.keep_out.push_back(sure);
  const PlanResult result = plan(compile(guessed), trials_of_shapes());
  ASSERT_FALSE(result.grasps.empty());
  for (const ScoredGrasp& grasp : result.grasps) {
    ASSERT_TRUE(grasp.shapes);
    EXPECT_EQ(grasp.shapes->thin, false);
  }
}

TEST(TryShapes, AnObjectThatIsKnownIsNotTriedAgain) {
  Scene scene = half_seen();
  scene.object.completion.reset();
  const PlanResult result = plan(compile(scene), trials_of_shapes());
  ASSERT_FALSE(result.grasps.empty());
  EXPECT_FALSE(result.grasps.front().shapes);
}

TEST(TryShapes, AShapeThatOverlapsAnObstacleIsNotTried) {
  Scene scene = half_seen();
  scene.obstacles.push_back(test::obstacle(make_box({0.02, 0.02, 0.02}), {0.0, 0.0, 0.06}));
  const PlanResult result = plan(compile(scene), trials_of_shapes());
  ASSERT_FALSE(result.grasps.empty());
  EXPECT_TRUE(result.grasps.front().shapes->thin);
  EXPECT_FALSE(result.grasps.front().shapes->thick);
}

TEST(TryShapes, AWayThroughUnseenSpaceCosts) {
  Scene scene = half_seen();
  const PlanResult known = plan(compile(scene), trials_of_shapes());
  // A camera that sees a wall through the middle of the object, and nothing behind it.
  DepthView view{test::camera_at({-1.0, 0.0, 0.0}, Vector3::Zero()), {}};
  view.depth.assign(index(view.camera.width) * index(view.camera.height), 1.0F);
  scene.object.completion->unseen = std::make_shared<const UnseenSpace>(std::vector{view});
  const PlanResult result = plan(compile(scene), trials_of_shapes());
  int both = 0;
  for (const ScoredGrasp& grasp : result.grasps) {
    EXPECT_GT(grasp.shapes->unseen, 0.0);
    EXPECT_LE(grasp.shapes->unseen, 1.0);
    for (const ScoredGrasp& same : known.grasps) {
      if (same.tried != grasp.tried) continue;
      ++both;
      EXPECT_EQ(same.shapes->unseen, 0.0);
      EXPECT_NEAR(grasp.shapes->certainty,
                  (1.0 - 0.3 * grasp.shapes->unseen) * same.shapes->certainty, 1e-12);
    }
  }
  EXPECT_GT(both, 0);
}

TEST(TryShapes, TheSameOnAnyNumberOfThreads) {
  const CompiledScene scene = compile(half_seen());
  const PlanResult one = plan(scene, trials_of_shapes(), {.threads = 1});
  const PlanResult two = plan(scene, trials_of_shapes(), {.threads = 2});
  ASSERT_EQ(one.grasps.size(), two.grasps.size());
  for (std::size_t i = 0; i < one.grasps.size(); ++i) {
    EXPECT_EQ(one.grasps[i].tried, two.grasps[i].tried);
    EXPECT_EQ(one.grasps[i].shapes->thin, two.grasps[i].shapes->thin);
    EXPECT_EQ(one.grasps[i].shapes->thick, two.grasps[i].shapes->thick);
    EXPECT_EQ(one.grasps[i].shapes->certainty, two.grasps[i].shapes->certainty);
  }
}

TEST(TryShapes, OutOfTimeNothingChanges) {
  const CompiledScene scene = compile(half_seen());
  PlanResult result = plan(scene, trials_of_shapes());
  for (ScoredGrasp& grasp : result.grasps) grasp.shapes.reset();
  RunContext context;
  context.cancellation.request();
  try_shapes(scene, trials_of_shapes(), context, result);
  EXPECT_EQ(result.status, PlanStatus::cancelled);
  EXPECT_FALSE(result.grasps.front().shapes);
}

}  // namespace
}  // namespace prehend
