// Time in a session: what falls, what is held, and what becomes of the session.
#include "planner/live/moving_world.h"

#include <cmath>

#include <gtest/gtest.h>

#include "planner/live/grasp_score.h"
#include "planner/live/session.h"
#include "sim/scene/scene_file.h"
#include "tests/support/refusal_of.h"

namespace prehend::test {
namespace {

// A ball of radius 30 mm, of 0.3 kg, and a parallel jaw above it.
Session session_of_ball() {
  Session session;
  session.set_scene(scene_of_hand("parallel_jaw"));
  session.edit([](Scene& scene) {
    set_object(scene, surface_of({.generate = "ball", .triangles = 800}, {}), {.name = "ball"});
  });
  return session;
}

double object_mass(const Session& session) { return session.state().world->scene().object.mass; }

// The force of all contacts on the object [N].
Vector3 force_on_object(const World& world) {
  Vector3 sum = Vector3::Zero();
  for (const WorldContact& contact : world.contacts) {
    if (contact.a == kObjectSolid) sum += contact.impulse_W / world.last_step;
    if (contact.b == kObjectSolid) sum -= contact.impulse_W / world.last_step;
  }
  return sum;
}

// Everything that a client sees of it, to the bit.
std::vector<double> all_of(const MovingWorld& moving) {
  const RigidMotion& motion = moving.object();
  std::vector<double> all(motion.X_WB.matrix().data(), motion.X_WB.matrix().data() + 16);
  const HandPosture posture = moving.posture();
  all.insert(all.end(), posture.joints.begin(), posture.joints.end());
  for (int i = 0; i < 3; ++i) {
    all.push_back(motion.linear[i]);
    all.push_back(motion.angular[i]);
  }
  all.push_back(moving.time());
  return all;
}

TEST(MovingWorld, WhatIsFreeFalls) {
  Session session = session_of_ball();
  for (const double step : {5e-4, 2.5e-3, 1e-2}) {
    session.start_time({.step = step});
    const double from = session.time().object().X_WB.translation().z();
    EXPECT_EQ(session.moving().advance(0.2), StepOutcome::moved);
    const RigidMotion& motion = session.time().object();
    EXPECT_NEAR(motion.X_WB.translation().z() - from, -0.5 * 9.81 * 0.2 * 0.2, 1e-9);
    EXPECT_NEAR(motion.linear.z(), -9.81 * 0.2, 1e-9);
    EXPECT_EQ(session.time().time(), 0.2);
    session.stop_time(false);
  }
  session.start_time({.gravity = false});
  session.moving().advance(0.2);
  EXPECT_EQ(session.time().object().linear, Vector3::Zero());
}

TEST(MovingWorld, AHeldObjectStaysAndItsContactsBearItsWeight) {
  Session session = session_of_ball();
  session.approach(0.5);
  ASSERT_EQ(session.auto_grasp().outcome, Outcome::stable);
  session.start_time({});
  const MovingWorld start = session.time();
  for (std::size_t d = 0; d < start.drives().size(); ++d) {
    session.moving().drive(
        d, {.effort =
                std::copysign(10.0, session.state().world->scene().hand.dofs[d].closing_velocity)});
  }
  for (int i = 0; i < 2; ++i) ASSERT_LT(session.moving().advance(0.5), StepOutcome::blocked);
  const MovingWorld& now = session.time();
  // From where the fingers stand off by the gap of contacts, 0.1 mm each.
  EXPECT_LT((now.object().X_WB.translation() - start.object().X_WB.translation()).norm(), 5e-4);
  EXPECT_LT(now.object().linear.norm(), 1e-3);
  const Vector3 weight(0.0, 0.0, 9.81 * object_mass(session));
  EXPECT_LT((force_on_object(now.world()) - weight).norm(), 1e-2 * weight.norm());
}

TEST(MovingWorld, ASpringHoldsTheObjectWhereItBalancesTheWeight) {
  Session session = session_of_ball();
  session.back_off(0.2);
  session.start_time({});
  const Vector3 center = session.state().world->scene().object.center_of_mass;
  const Vector3 to_W = session.time().object().X_WB * center + Vector3(0.02, 0.0, 0.0);
  session.moving().pull(ObjectPull{center, to_W, 200.0});
  for (int i = 0; i < 3; ++i) session.moving().advance(1.0);
  const Vector3 sag(0.0, 0.0, -9.81 * object_mass(session) / 200.0);
  EXPECT_LT((session.time().object().X_WB * center - to_W - sag).norm(), 1e-6);
  // From a point at its side it hangs until that is above the middle.
  const Vector3 side = center + Vector3(0.03, 0.0, 0.0);
  session.moving().pull(ObjectPull{side, to_W, 100.0});
  for (int i = 0; i < 10; ++i) session.moving().advance(1.0);
  const Pose& X_WO = session.time().object().X_WB;
  const Vector3 hangs = X_WO * side - X_WO * center;
  EXPECT_GT(hangs.normalized().z(), 0.99);
  EXPECT_EQ(refusal_of([&] {
              session.moving().pull(ObjectPull{side, to_W, 1e6});
            }).field(),
            "stiffness");
  session.moving().pull(std::nullopt);
  session.moving().advance(0.0025);
  EXPECT_EQ(session.time().world().bodies[0].force_W, Vector3::Zero());
}

TEST(MovingWorld, DrivesReachTheirTargetsAndThenHold) {
  Session session = session_of_ball();
  session.back_off(0.3);
  session.start_time({.gravity = false});
  const DegreeOfFreedom& dof = session.state().world->scene().hand.dofs[0];
  const double target = 0.5 * (dof.lower + dof.upper);
  session.moving().drive(0, {.target = target});
  for (int i = 0; i < 4; ++i) session.moving().advance(1.0);
  EXPECT_NEAR(session.time().posture().dofs[0], target, 1e-6);
  session.moving().drive(0, {});
  session.moving().advance(0.5);
  EXPECT_NEAR(session.time().posture().dofs[0], target, 1e-6);
  session.moving().drive(0, {.target = dof.upper + 1.0});
  EXPECT_EQ(session.time().drives()[0].target, dof.upper);
  session.moving().drive(0, {.effort = 1e9});
  EXPECT_EQ(session.time().drives()[0].effort, session.time().world().robots[0].model->effort[0]);
}

TEST(MovingWorld, ResetAndTheSameCallsGiveTheSameBytes) {
  Session session = session_of_ball();
  session.approach(0.5);
  session.start_time({});
  const auto run = [&] {
    session.moving().drive(0, {.effort = 5.0});
    session.moving().pull(ObjectPull{{0.01, 0.0, 0.02}, {0.0, 0.1, 0.1}, 50.0});
    std::vector<double> all;
    for (int i = 0; i < 40; ++i) {
      session.moving().advance(0.01);
      const std::vector<double> now = all_of(session.time());
      all.insert(all.end(), now.begin(), now.end());
    }
    return all;
  };
  const std::vector<double> start = all_of(session.time());
  const std::vector<double> once = run();
  session.reset_time();
  EXPECT_EQ(all_of(session.time()), start);
  EXPECT_FALSE(session.time().pulling());
  EXPECT_EQ(run(), once);
}

TEST(MovingWorld, WhileTimeRunsNothingElseMoves) {
  Session session = session_of_ball();
  EXPECT_EQ(refusal_of([&] { session.moving(); }).field(), "command");
  EXPECT_EQ(refusal_of([&] { session.start_time({.step = 0.1}); }).field(), "step");
  session.set_dofs({0.0, 0.0});
  session.start_time({});
  const std::uint64_t revision = session.revision();
  const auto refused = [&](const auto& call) {
    const std::string problem = refusal_of(call).problem();
    EXPECT_EQ(problem.substr(0, 15), "time is running") << problem;
  };
  refused([&] { session.undo(); });
  refused([&] { session.redo(); });
  refused([&] { session.set_scene(scene_of_hand("barrett")); });
  refused([&] { session.edit([](Scene& /*scene*/) {}); });
  refused([&] { session.back_off(0.1); });
  refused([&] { session.approach(0.5); });
  refused([&] { session.open_hand(); });
  refused([&] { session.auto_grasp(); });
  refused([&] { session.start_plan({}); });
  refused([&] { session.start_time({}); });
  for (const double seconds : {0.0, -1.0, 1.1}) {
    EXPECT_EQ(refusal_of([&] { session.moving().advance(seconds); }).field(), "seconds");
  }
  EXPECT_EQ(session.revision(), revision);
  session.set_switches({.soft_fingers = false});
  session.stop_time(false);
  EXPECT_TRUE(session.undo());
}

TEST(MovingWorld, AnObjectThatOverlapsTheHandDoesNotMove) {
  Session session = session_of_ball();
  session.set_switches({.stop_at_contact = false});
  session.move_hand(Pose::Identity());
  (void)refusal_of([&] { session.start_time({}); });
  EXPECT_FALSE(session.is_moving());
}

TEST(MovingWorld, WhatIsKeptIsOneStepOfUndo) {
  Session session = session_of_ball();
  const Pose before = session.state().world->X_WO();
  const Pose X_WH = session.X_WH();
  const std::size_t undos = session.undo_count();
  session.start_time({});
  session.moving().drive(0, {.target = 0.01});
  session.moving().advance(0.1);
  const Pose after = session.time().object().X_WB;
  const HandPosture posture = session.time().posture();
  session.stop_time(true);
  EXPECT_FALSE(session.is_moving());
  EXPECT_EQ(session.state().world->X_WO().matrix(), after.matrix());
  EXPECT_TRUE(session.X_WH().isApprox(X_WH, 1e-12));
  EXPECT_EQ(session.state().hand.dofs, posture.dofs);
  EXPECT_EQ(session.state().hand.joints, posture.joints);
  EXPECT_EQ(session.undo_count(), undos + 1);
  EXPECT_TRUE(session.undo());
  EXPECT_EQ(session.state().world->X_WO().matrix(), before.matrix());
}

// Surfaces of a moving world may cross by some hundredths of a millimetre; those that are kept do
// not, whenever time ends.
TEST(MovingWorld, WhatIsKeptOverlapsNothing) {
  Session session;
  session.set_scene(scene_of_hand("barrett"));
  session.edit([](Scene& scene) {
    set_object(scene, surface_of({.generate = "ball", .triangles = 800}, {}), {.name = "ball"});
  });
  session.approach(0.5);
  for (int moment = 1; moment <= 12; ++moment) {
    session.start_time({.gravity = false});
    for (std::size_t d = 1; d < 4; ++d) session.moving().drive(d, {.effort = 5.0});
    for (int i = 0; i < moment; ++i) session.moving().advance(0.1);
    session.stop_time(true);
    const SessionState& state = session.state();
    EXPECT_TRUE(overlaps_of(state.world->compiled(), state.hand.X_OH, state.hand.joints).empty())
        << moment;
    session.undo();
  }
}

// What time has moved is no longer the grasp that a plan has found, and the arm is looked at anew.
TEST(MovingWorld, WhatIsKeptIsNoGraspOfAPlan) {
  Session session;
  session.set_scene(load_scene("panda_on_table"));
  PlanOptions plan;
  plan.search.trials = 100;
  session.start_plan(plan);
  session.finish_plan();
  session.go_to(0);
  ASSERT_NE(session.state().grasp, nullptr);
  ASSERT_TRUE(session.state().arm->reached());
  const Pose X_WH = session.X_WH();
  session.start_time({});
  session.moving().drive(0, {.target = 0.0});
  session.moving().advance(0.05);
  session.stop_time(true);
  EXPECT_EQ(session.state().grasp, nullptr);
  EXPECT_FALSE(session.state().outcome.has_value());
  EXPECT_TRUE(session.X_WH().isApprox(X_WH, 1e-9));
  ASSERT_TRUE(session.state().arm->holds_hand);
  const Pose X_OH = hand_on_arm(*session.arm(), session.state().arm->dofs);
  EXPECT_TRUE(X_OH.isApprox(session.state().hand.X_OH, 1e-6));
}

}  // namespace
}  // namespace prehend::test
