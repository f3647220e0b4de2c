// Plans that run while a session goes on.
#include <future>

#include <gtest/gtest.h>

#include "planner/live/session.h"
#include "sim/base/json/json_field.h"
#include "tests/support/refusal_of.h"

namespace prehend::test {
namespace {

Session cylinder_session() {
  Session session;
  session.set_scene(scene_of_hand("parallel_jaw"));
  session.edit([](Scene& scene) {
    set_object(scene, surface_of({.generate = "cylinder", .triangles = 600}, {}), {});
  });
  return session;
}

PlanOptions short_plan(int trials) {
  PlanOptions options;
  options.search.trials = trials;
  options.volumes = false;
  return options;
}

TEST(SessionPlan, ResultsAreThoseOfPlan) {
  Session session = cylinder_session();
  std::atomic<int> found = 0;
  session.start_plan(short_plan(60), {.found = [&](const Candidate&, const Trial& trial) {
                       EXPECT_EQ(trial.outcome, Outcome::stable);
                       ++found;
                     }});
  EXPECT_EQ(session.finish_plan(), "");
  const PlanResult direct = plan(session.state().world->compiled(), short_plan(60));
  const PlanResult& kept = *session.state().results;
  ASSERT_EQ(kept.grasps.size(), direct.grasps.size());
  ASSERT_FALSE(kept.grasps.empty());
  EXPECT_GE(found, static_cast<int>(kept.grasps.size()));
  EXPECT_EQ(kept.grasps[0].trial.epsilon.lower, direct.grasps[0].trial.epsilon.lower);
  session.go_to(0);
  EXPECT_NEAR(session.quality().epsilon.lower, kept.grasps[0].trial.epsilon.lower, 1e-9);
  session.pin("best");
  EXPECT_EQ(session.state().pins.at(0).epsilon, session.quality().epsilon.lower);
  session.unpin("best");
  EXPECT_TRUE(session.undo());
  EXPECT_EQ(session.state().pins.size(), 1U);
}

TEST(SessionPlan, TheSceneCannotChangeMeanwhileButTheHandMoves) {
  Session session = cylinder_session();
  session.start_plan(short_plan(100000));
  EXPECT_EQ(refusal_of([&] { session.set_scene(scene_of_hand("barrett")); }).field(), "command");
  EXPECT_EQ(refusal_of([&] { session.undo(); }).field(), "command");
  EXPECT_EQ(refusal_of([&] { session.start_plan({}); }).field(), "command");
  session.back_off(0.01);
  session.plan_cancellation()->request();
  (void)session.finish_plan();
  EXPECT_FALSE(session.is_planning());
  EXPECT_EQ(refusal_of([&] { (void)session.finish_plan(); }).field(), "command");
}

TEST(SessionPlan, WhatACancelledPlanHasFoundIsKeptAndComesAgainFromItsText) {
  Session session = cylinder_session();
  Session again = cylinder_session();
  std::promise<void> some;
  bool told = false;
  session.start_plan(short_plan(100000), {.found = [&](const Candidate&, const Trial&) {
                       if (!told) some.set_value();
                       told = true;
                     }});
  some.get_future().wait();
  session.plan_cancellation()->request();
  const std::string text = session.finish_plan();
  ASSERT_NE(text, "");
  ASSERT_FALSE(session.state().results->grasps.empty());
  EXPECT_EQ(session.state().results->status, PlanStatus::cancelled);
  again.keep_results(text);
  session.go_to(0);
  again.go_to(0);
  EXPECT_EQ(session.state().hand.X_OH.matrix(), again.state().hand.X_OH.matrix());
  EXPECT_EQ(session.state().hand.joints, again.state().hand.joints);
  EXPECT_EQ(session.grasps_text(), again.grasps_text());
  // Another world has no results of this one.
  session.edit([](Scene& scene) { change_object(scene, {.mass = 1.0}); });
  EXPECT_EQ(session.state().results, nullptr);
  EXPECT_TRUE(session.undo());
  EXPECT_NE(session.state().results, nullptr);
}

}  // namespace
}  // namespace prehend::test
