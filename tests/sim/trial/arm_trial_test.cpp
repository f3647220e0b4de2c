// Trials of a hand on an arm: how they end, and that the arm changes nothing about the grasp.
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "sim/base/index.h"
#include "sim/base/random.h"
#include "sim/scene/reach/motion_check.h"
#include "tests/support/block_on_table.h"
#include "tests/support/library_scenes.h"
#include "tests/support/scenes.h"

namespace prehend {
namespace {

using test::block_on_table;
using test::from_above;
using test::Grasp;
using test::stable_grasp;

Pose hand_in_base(const CompiledArm& arm, const std::vector<double>& dofs) {
  std::vector<Pose> X_BJ;
  joint_poses(arm.robot(), joint_values(arm.robot(), dofs), X_BJ);
  return X_BJ[index(arm.hand_part().joint)] * arm.hand_part().X_JR;
}

// Every number of the grasp, the arm's aside.
void expect_same_grasp(const Trial& a, const Trial& b) {
  EXPECT_EQ(a.outcome, b.outcome);
  EXPECT_EQ(a.X_OH.matrix(), b.X_OH.matrix());
  EXPECT_EQ(a.travel, b.travel);
  EXPECT_EQ(a.back_offs, b.back_offs);
  EXPECT_EQ(a.turned, b.turned);
  EXPECT_EQ(a.dofs, b.dofs);
  EXPECT_EQ(a.joints, b.joints);
  EXPECT_EQ(a.epsilon.lower, b.epsilon.lower);
  EXPECT_EQ(a.epsilon.upper, b.epsilon.upper);
  EXPECT_EQ(a.epsilon.weakest, b.epsilon.weakest);
  ASSERT_EQ(a.contacts.size(), b.contacts.size());
  for (std::size_t c = 0; c < a.contacts.size(); ++c) {
    EXPECT_EQ(a.contacts[c].link, b.contacts[c].link);
    EXPECT_EQ(a.contacts[c].gap, b.contacts[c].gap);
    EXPECT_EQ(a.contacts[c].point.position, b.contacts[c].point.position);
    EXPECT_EQ(a.contacts[c].point.normal, b.contacts[c].point.normal);
  }
}

void expect_no_grasp(const Trial& trial) {
  EXPECT_TRUE(trial.contacts.empty());
  EXPECT_TRUE(trial.arm_dofs.empty());
  EXPECT_TRUE(trial.arm_line.empty());
  EXPECT_EQ(trial.epsilon.lower, 0.0);
}

Scene without_arm(Scene scene) {
  scene.carrier.reset();
  return scene;
}

TEST(ArmTrial, AStableGraspHasAPostureOfTheArmThatHoldsTheHandThere) {
  const CompiledScene scene = compile(block_on_table());
  const CompiledArm& arm = *scene.arm;
  const Trial trial = stable_grasp(scene).trial;
  ASSERT_EQ(trial.arm_dofs.size(), arm.robot().dofs.size());
  EXPECT_FALSE(trial.arm_pair.has_value());
  for (std::size_t d = 0; d < trial.arm_dofs.size(); ++d) {
    EXPECT_GE(trial.arm_dofs[d], arm.robot().dofs[d].lower);
    EXPECT_LE(trial.arm_dofs[d], arm.robot().dofs[d].upper);
  }
  const Pose X_OH = arm.X_BO.inverse() * hand_in_base(arm, trial.arm_dofs);
  EXPECT_TRUE(X_OH.isApprox(trial.X_OH, 1e-8));
  EXPECT_FALSE(first_meeting(arm, arm.arm_pairs, joint_values(arm.robot(), trial.arm_dofs)));
  EXPECT_EQ(collision_of(scene, trial).link, "");
}

TEST(ArmTrial, KeepsThePosturesOfTheArmAlongTheApproach) {
  const CompiledScene scene = compile(block_on_table());
  const CompiledArm& arm = *scene.arm;
  const Grasp grasp = stable_grasp(scene);
  const std::vector<DofValues>& line = grasp.trial.arm_line;
  ASSERT_GT(line.size(), 2U);
  EXPECT_EQ(line.back(), grasp.trial.arm_dofs);
  const HandLine hand = approach_line(scene, grasp.candidate, grasp.trial);
  const Vector3 way = hand.X_OH_to.translation() - hand.X_OH_from.translation();
  for (std::size_t i = 0; i < line.size(); ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(line.size() - 1);
    Pose X_OH = hand.X_OH_from;
    X_OH.translation() += part * way;
    EXPECT_TRUE((arm.X_BO.inverse() * hand_in_base(arm, line[i])).isApprox(X_OH, 1e-8)) << i;
    for (std::size_t d = 0; i > 0 && d < line[i].size(); ++d) {
      EXPECT_LE(std::abs(line[i][d] - line[i - 1][d]), ReachOptions{}.largest_joint_step);
    }
  }
}

TEST(ArmTrial, TheArmChangesNothingAboutTheGrasp) {
  const CompiledScene scene = compile(block_on_table());
  const CompiledScene free = compile(without_arm(block_on_table()));
  int stable = 0;
  for (int i = 0; i < 12; ++i) {
    const Candidate candidate = from_above(scene.scene.hand, 0.5236 * i);
    const Trial carried = run_trial(scene, candidate);
    if (carried.outcome == Outcome::unreachable || carried.outcome == Outcome::arm_blocked)
      continue;
    expect_same_grasp(carried, run_trial(free, candidate));
    stable += carried.outcome == Outcome::stable ? 1 : 0;
  }
  EXPECT_GE(stable, 2);
}

TEST(ArmTrial, WithoutAnArmNothingIsSaidOfOne) {
  const CompiledScene free = compile(without_arm(block_on_table()));
  EXPECT_FALSE(free.arm.has_value());
  Random random(101);
  for (int i = 0; i < 40; ++i) {
    Candidate candidate = from_above(free.scene.hand, random.uniform(0.0, 6.28));
    candidate.X_OH.translation() += random.in_box(0.03);
    const Trial trial = run_trial(free, candidate);
    EXPECT_TRUE(trial.arm_dofs.empty());
    EXPECT_FALSE(trial.arm_pair.has_value());
    EXPECT_NE(trial.outcome, Outcome::unreachable);
    EXPECT_NE(trial.outcome, Outcome::arm_blocked);
    EXPECT_NE(trial.outcome, Outcome::no_path);
  }
}

TEST(ArmTrial, TooFarAwayIsUnreachable) {
  Scene scene = block_on_table();
  scene.object.X_WO.translation().x() += 5.0;
  scene.obstacles.clear();
  const CompiledScene far = compile(scene);
  for (int i = 0; i < 12; ++i) {
    const Candidate candidate = from_above(scene.hand, 0.5236 * i);
    const Trial trial = run_trial(far, candidate);
    EXPECT_EQ(trial.outcome, Outcome::unreachable);
    EXPECT_FALSE(trial.arm_pair.has_value());
    EXPECT_EQ(collision_of(far, trial).by, "");
    expect_no_grasp(trial);
  }
}

// A cube in the forearm of every posture that could hold the hand at the pre-grasp.
StaticBody cubes_in_forearms(const CompiledScene& scene, const Grasp& grasp) {
  const CompiledArm& arm = *scene.arm;
  const HandLine line = approach_line(scene, grasp.candidate, grasp.trial);
  StaticBody cubes;
  cubes.name = "cubes";
  for (const auto& dofs : postures_at(arm, line.X_OH_from, {})) {
    std::vector<Pose> X_BL;
    arm_link_poses(arm, arm_joints(arm, dofs, line.hand_joints), X_BL);
    for (std::size_t l = 0; l < X_BL.size(); ++l) {
      if (arm.links[l].name != "arm/forearm") continue;
      const Vector3 middle = arm.links[l].mesh.ball_center();
      append(cubes.mesh,
             transformed(make_box({0.04, 0.04, 0.04}), arm.X_WB * X_BL[l] * translation(middle)));
    }
  }
  return cubes;
}

TEST(ArmTrial, AnArmThatMeetsAnObstacleIsBlockedByIt) {
  Scene scene = block_on_table();
  const CompiledScene before = compile(scene);
  const Grasp grasp = stable_grasp(before);
  scene.obstacles.push_back(cubes_in_forearms(before, grasp));
  const CompiledScene after = compile(scene);
  const Trial trial = run_trial(after, grasp.candidate);
  ASSERT_EQ(trial.outcome, Outcome::arm_blocked);
  expect_no_grasp(trial);
  const CollisionNames colliding = collision_of(after, trial);
  EXPECT_EQ(colliding.link.rfind("arm/", 0), 0U) << colliding.link;
  EXPECT_EQ(colliding.by, "cubes");
  // The hand itself was free.
  EXPECT_EQ(run_trial(compile(without_arm(scene)), grasp.candidate).outcome, Outcome::stable);
}

// A small block at a place that the palm takes, in the object's frame.
Scene with_block_at(Scene scene, const Vector3& p_O) {
  StaticBody block = test::obstacle(make_box({0.02, 0.02, 0.004}), scene.object.X_WO * p_O);
  block.name = "brick";
  scene.obstacles.push_back(std::move(block));
  return scene;
}

void expect_hand_stopped(Outcome expected, double above_the_palm) {
  const Scene scene = block_on_table();
  Grasp grasp = stable_grasp(compile(scene));
  // From so far away that the fingers do not reach the object where the hand is stopped.
  constexpr double kFarther = 0.1;
  const Pose X_OH = translation(-kFarther * grasp.candidate.approach_O) *
                    approach_line(compile(scene), grasp.candidate, grasp.trial).X_OH_from;
  grasp.candidate.approach_distance += kFarther;
  const Vector3 palm = X_OH * scene.hand.hand->origin;
  const Vector3 at = palm - above_the_palm * grasp.candidate.approach_O;
  const CompiledScene blocked = compile(with_block_at(scene, at));
  const Trial trial = run_trial(blocked, grasp.candidate);
  ASSERT_EQ(trial.outcome, expected) << name_of(trial.outcome);
  EXPECT_FALSE(trial.arm_pair.has_value());
  expect_no_grasp(trial);
  EXPECT_EQ(collision_of(blocked, trial).by, "brick");
  EXPECT_EQ(collision_of(blocked, trial).link, "palm");
}

TEST(ArmTrial, ABrickInThePalmAtThePreGraspBlocksTheHand) {
  expect_hand_stopped(Outcome::hand_blocked, 0.01);
}
TEST(ArmTrial, ABrickBeforeThePalmBlocksTheApproach) {
  expect_hand_stopped(Outcome::approach_blocked, -0.03);
}

TEST(ArmTrial, ATrialRepeats) {
  const CompiledScene scene = compile(block_on_table());
  const Grasp grasp = stable_grasp(scene);
  const Trial again = run_trial(scene, grasp.candidate);
  expect_same_grasp(again, grasp.trial);
  EXPECT_EQ(again.arm_dofs, grasp.trial.arm_dofs);
  EXPECT_EQ(again.arm_line, grasp.trial.arm_line);
}

}  // namespace
}  // namespace prehend
