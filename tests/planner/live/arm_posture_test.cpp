// Arms that follow the hand of a session.
#include "planner/live/arm_posture.h"

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "planner/live/session.h"
#include "sim/base/index.h"
#include "sim/base/json/json_field.h"
#include "sim/base/random.h"
#include "sim/scene/scene_file.h"
#include "tests/support/refusal_of.h"

namespace prehend::test {
namespace {

Session arm_session(const char* scene) {
  Session session;
  session.set_scene(load_scene(scene));
  return session;
}

// Whether the arm has the hand where the session has it.
void expect_held(const Session& session) {
  const Pose on_arm = hand_on_arm(session.require_arm(), session.state().arm->dofs);
  EXPECT_LT((on_arm.matrix() - session.state().hand.X_OH.matrix()).norm(), 1e-7);
}

std::vector<double> values_of(const Session& session) {
  std::vector<double> values;
  for (const int d : session.require_arm().dofs) {
    values.push_back(session.state().arm->dofs[index(d)]);
  }
  return values;
}

TEST(ArmPosture, FollowsADraggedHandWithoutJumps) {
  for (const char* scene : {"panda_on_table", "ur5e_on_table"}) {
    Session session = arm_session(scene);
    ASSERT_TRUE(session.state().arm->reached()) << session.state().arm->problem;
    expect_held(session);
    const Pose start = session.state().hand.X_OH;
    for (int i = 1; i <= 40; ++i) {
      const std::vector<double> before = values_of(session);
      const Vector3 by(0.08 * std::sin(0.1 * i), 0.06 * std::sin(0.15 * i), 0.002 * i);
      session.move_hand(translation(by) * start, 1);
      ASSERT_TRUE(session.state().arm->reached()) << scene << i << session.state().arm->problem;
      expect_held(session);
      for (std::size_t j = 0; j < before.size(); ++j) {
        EXPECT_LT(std::abs(values_of(session)[j] - before[j]), 0.3) << scene << i;
      }
    }
    session.undo();
    EXPECT_EQ(session.state().hand.X_OH.matrix(), start.matrix());
    expect_held(session);
  }
}

TEST(ArmPosture, AHandOutOfReachMovesAllTheSameAndIsHeldAgainWhenItComesBack) {
  Session session = arm_session("ur5e_on_table");
  const Pose near = session.state().hand.X_OH;
  const std::vector<double> values = values_of(session);
  session.move_hand(translation({5.0, 0.0, 0.0}) * near);
  EXPECT_NEAR(session.state().hand.X_OH.translation().x(), near.translation().x() + 5.0, 1e-9);
  EXPECT_FALSE(session.state().arm->reached());
  EXPECT_NE(session.state().arm->problem, "");
  EXPECT_EQ(values_of(session), values);
  session.move_hand(near);
  EXPECT_TRUE(session.state().arm->reached());
  expect_held(session);
}

TEST(ArmPosture, MovedJointsCarryTheHandUntilItTouchesAndEndAtLimits) {
  Session session = arm_session("panda_on_table");
  Random random(5);
  int touched = 0;
  const std::size_t steps = session.undo_count();
  for (int i = 0; i < 60; ++i) {
    std::vector<double> values = values_of(session);
    for (double& value : values) value += random.uniform(-0.4, 0.4);
    const ArmMotion motion = session.set_arm(values, 3);
    expect_held(session);
    if (motion.end != MotionEnd::touched) continue;
    ++touched;
    EXPECT_NE(motion.link, "");
    EXPECT_NE(motion.by, "");
  }
  EXPECT_GT(touched, 3);
  EXPECT_TRUE(session.collisions().empty());
  EXPECT_EQ(session.undo_count(), steps + 1);
  session.set_switches({.stop_at_contact = false});
  const CompiledArm& arm = session.require_arm();
  session.set_arm(std::vector<double>(arm.dofs.size(), 100.0));
  for (const int d : arm.dofs) {
    EXPECT_EQ(session.state().arm->dofs[index(d)], arm.robot().dofs[index(d)].upper);
  }
  expect_held(session);
  EXPECT_EQ(refusal_of([&] { session.set_arm({0.0}); }).field(), "joints");
}

TEST(ArmPosture, EveryBranchHoldsTheHandAndTellsWhetherItCollides) {
  Session session = arm_session("ur5e_on_table");
  const Pose X_OH = session.state().hand.X_OH;
  const std::vector<ArmBranch> branches = session.branches();
  ASSERT_GT(branches.size(), 2U);
  for (std::size_t i = 0; i < branches.size(); ++i) {
    session.choose_branch(i);
    EXPECT_EQ(session.state().hand.X_OH.matrix(), X_OH.matrix());
    expect_held(session);
    EXPECT_EQ(session.state().arm->dofs, branches[i].dofs);
    EXPECT_EQ(session.state().arm->reached(), branches[i].link.empty());
    const std::vector<Overlap> overlaps = session.collisions();
    EXPECT_EQ(overlaps.empty(), branches[i].link.empty()) << i;
    if (overlaps.empty()) continue;
    EXPECT_EQ(overlaps.front().link, branches[i].link);
  }
  EXPECT_EQ(refusal_of([&] { session.choose_branch(branches.size()); }).field(), "branch");
}

TEST(ArmPosture, TheArmStaysWithTheHandWhenTheObjectMoves) {
  Session session = arm_session("panda_on_table");
  const DofValues before = session.state().arm->dofs;
  session.move_object(translation({0.0, 0.05, 0.0}) * session.state().world->X_WO());
  EXPECT_TRUE(session.state().arm->reached());
  EXPECT_EQ(session.state().arm->dofs, before);
  expect_held(session);
  const Trial trial = session.auto_grasp();
  EXPECT_NE(trial.outcome, Outcome::hand_blocked);
  expect_held(session);
}

TEST(ArmPosture, AFreeHandHasNone) {
  Session session = arm_session("mug");
  EXPECT_FALSE(session.state().arm.has_value());
  EXPECT_EQ(session.arm(), nullptr);
  EXPECT_EQ(refusal_of([&] { (void)session.branches(); }).field(), "command");
  EXPECT_EQ(refusal_of([&] { session.set_arm({}); }).field(), "command");
}

}  // namespace
}  // namespace prehend::test
