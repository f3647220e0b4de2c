// Grasps in hand: refined, and played back from where the robot starts.
#include "planner/live/grasp_in_hand.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "planner/live/session.h"
#include "sim/base/json/json_field.h"
#include "sim/scene/scene_file.h"
#include "tests/support/refusal_of.h"
#include "tests/support/scenes.h"

namespace prehend::test {
namespace {

Session holding_session(int threads) {
  SessionOptions options;
  options.threads = threads;
  Session session(options);
  session.set_scene(scene_of_hand("barrett"));
  session.edit([](Scene& scene) {
    set_object(scene, surface_of({.generate = "cylinder", .triangles = 600}, {}), {});
  });
  session.approach(0.5);
  session.back_off(0.005);
  EXPECT_EQ(session.auto_grasp().outcome, Outcome::stable);
  return session;
}

TEST(GraspInHand, RefinementMakesItBetterInOneStepAndTheSameOnAnyNumberOfThreads) {
  Session session = holding_session(1);
  const double epsilon = session.quality().epsilon.lower;
  const HandPosture before = session.state().hand;
  const std::size_t steps = session.undo_count();
  const Refined refined = session.refine(60, 1);
  EXPECT_NEAR(refined.before, epsilon, 1e-12);
  ASSERT_GT(refined.after, refined.before);
  EXPECT_LE(refined.trials, 60);
  EXPECT_EQ(session.undo_count(), steps + 1);
  EXPECT_EQ(session.state().outcome, Outcome::stable);
  EXPECT_NEAR(session.quality().epsilon.lower, refined.after, 1e-9);
  EXPECT_EQ(collision(session.state().world->compiled(), session.state().hand.X_OH,
                      session.state().hand.joints),
            "");
  Session other = holding_session(3);
  EXPECT_EQ(other.refine(60, 1).after, refined.after);
  EXPECT_EQ(other.state().hand.X_OH.matrix(), session.state().hand.X_OH.matrix());
  EXPECT_EQ(other.state().hand.joints, session.state().hand.joints);
  EXPECT_TRUE(session.undo());
  EXPECT_EQ(session.state().hand.X_OH.matrix(), before.X_OH.matrix());
}

GraspPlayback path_to_grasp(Session& session, bool lift) {
  session.start_path(1, lift);
  (void)session.finish_path();
  return session.path().playback;
}

TEST(GraspInHand, HandsThatHoldNothingAreRefused) {
  Session session = holding_session(1);
  session.back_off(0.2);
  EXPECT_EQ(refusal_of([&] { session.refine(20, 1); }).field(), "hand");
  EXPECT_EQ(refusal_of([&] { session.start_path(1, true); }).field(), "hand");
  EXPECT_EQ(refusal_of([&] { session.refine(1, 1); }).field(), "trials");
}

TEST(GraspInHand, AFreeHandComesBackAndClosesToWhereItIs) {
  Session session = holding_session(1);
  const HandPosture closed = session.state().hand;
  const GraspPlayback played = path_to_grasp(session, true);
  ASSERT_TRUE(played.found) << played.problem;
  const std::vector<MotionFrame>& frames = played.motion.frames;
  ASSERT_GT(frames.size(), 10U);
  EXPECT_EQ(frames.front().time, 0.0);
  for (std::size_t i = 1; i < frames.size(); ++i) {
    EXPECT_LE(frames[i].time - frames[i - 1].time, kPlaybackStep + 1e-9);
    EXPECT_GT(frames[i].time, frames[i - 1].time);
    EXPECT_EQ(collision(session.state().world->compiled(), frames[i].X_OH, frames[i].joints), "")
        << i;
  }
  EXPECT_EQ(frames.back().X_OH.matrix(), closed.X_OH.matrix());
  EXPECT_EQ(frames.back().joints, closed.joints);
  EXPECT_EQ(played.motion.segments.back().name, "close");
}

TEST(GraspInHand, AHandThatWasClosedByItsDegreesOfFreedomOpensAsFarAsItCan) {
  Session session = holding_session(1);
  // The same posture, of which nobody knows how it came about.
  session.set_dofs(session.state().hand.dofs);
  ASSERT_EQ(session.state().grasp, nullptr);
  const GraspPlayback played = path_to_grasp(session, true);
  ASSERT_TRUE(played.found) << played.problem;
  EXPECT_EQ(played.motion.frames.back().joints, session.state().hand.joints);
  EXPECT_GT(session.refine(40, 1).after, 0.0);
}

// In clutter the planner finds grasps that the hand does not approach, from a preshape.
TEST(GraspInHand, ResultsWithoutAnApproachArePlayedBackToo) {
  Session session;
  session.set_scene(load_scene("cluttered_table"));
  PlanOptions options;
  options.search.trials = 100;
  options.volumes = false;
  options.rank.top = 100;
  session.start_plan(options);
  (void)session.finish_plan();
  const std::vector<ScoredGrasp> grasps = session.state().results->grasps;
  int in_place = 0;
  for (std::size_t i = 0; i < grasps.size(); ++i) {
    if (grasps[i].candidate.approach_distance > 0.0 || in_place == 2) continue;
    ++in_place;
    session.go_to(i);
    const GraspPlayback played = path_to_grasp(session, false);
    EXPECT_EQ(played.found, played.problem.empty());
    EXPECT_EQ(played.found, !played.motion.frames.empty());
  }
  EXPECT_GT(in_place, 0);
}

TEST(GraspInHand, AnArmComesFromItsStartPosture) {
  Session session;
  session.set_scene(load_scene("panda_on_table"));
  PlanOptions options;
  options.search.trials = 60;
  options.volumes = false;
  session.start_plan(options);
  (void)session.finish_plan();
  ASSERT_FALSE(session.state().results->grasps.empty());
  session.go_to(0);
  ASSERT_TRUE(session.state().arm->reached()) << session.state().arm->problem;
  const CompiledArm& arm = session.require_arm();
  const GraspPlayback played = path_to_grasp(session, false);
  ASSERT_TRUE(played.found) << played.problem;
  const std::vector<MotionFrame>& frames = played.motion.frames;
  EXPECT_EQ(frames.front().arm_joints, joint_values(arm.robot(), arm.start));
  for (std::size_t i = 1; i < frames.size(); ++i) {
    EXPECT_LE(frames[i].time - frames[i - 1].time, kPlaybackStep + 1e-9);
  }
  EXPECT_LT((frames.back().X_OH.matrix() - session.state().hand.X_OH.matrix()).norm(), 1e-6);
  const GraspPlayback again = path_to_grasp(session, false);
  ASSERT_EQ(again.motion.frames.size(), frames.size());
  EXPECT_EQ(again.motion.frames.back().arm_joints, frames.back().arm_joints);
  // A refined grasp is one that the arm reaches.
  (void)session.refine(20, 1);
  EXPECT_TRUE(session.state().arm->reached()) << session.state().arm->problem;
  EXPECT_TRUE(session.collisions().empty());
}

}  // namespace
}  // namespace prehend::test
