#include "sim/motion/control/stated_gains.h"

#include <cmath>

#include <gtest/gtest.h>

#include "sim/motion/robot_dynamics.h"
#include "sim/motion/step_world.h"
#include "sim/robot/files/robot_file.h"
#include "tests/support/refusal_of.h"

namespace prehend {
namespace {

WorldRobot robot_at_start(Robot robot) {
  const std::vector<double> dofs = initial_dofs(robot);
  auto model = std::make_shared<const RobotModel>(make_robot_model(std::move(robot)));
  return make_world_robot("robot", std::move(model), Pose::Identity(), dofs);
}

void hold(World& world, double seconds) {
  for (double time = 0.0; time < seconds; time += 2.5e-3) {
    ASSERT_EQ(step_world(world).outcome, StepOutcome::moved);
  }
}

TEST(StatedGains, AreThoseOfTheFileAndCriticalWhereItStatesNone) {
  Robot robot = find_robot("ur5e");
  robot.dofs[0].stiffness = 300.0;
  robot.dofs[1].damping = 7.0;
  robot.dofs[2].stiffness = 200.0;
  robot.dofs[2].damping = 0.0;
  const WorldRobot arm = robot_at_start(robot);
  const PdGains gains = stated_gains(arm, 2.0);
  const PdGains critical = critically_damped(arm, 2.0);
  const Eigen::VectorXd inertia = moved_inertias(arm);
  EXPECT_EQ(gains.stiffness[0], 300.0);
  EXPECT_NEAR(gains.damping[0], 2.0 * std::sqrt(300.0 * inertia[0]), 1e-12);
  EXPECT_EQ(gains.stiffness[1], critical.stiffness[1]);
  EXPECT_EQ(gains.damping[1], 7.0);
  EXPECT_EQ(gains.stiffness[2], 200.0);
  EXPECT_EQ(gains.damping[2], 0.0);
  for (Eigen::Index d = 3; d < 6; ++d) {
    EXPECT_EQ(gains.stiffness[d], critical.stiffness[d]);
    EXPECT_EQ(gains.damping[d], critical.damping[d]);
    const double w = 2.0 * std::acos(-1.0) * 2.0;
    EXPECT_NEAR(gains.stiffness[d], w * w * inertia[d], 1e-12 * gains.stiffness[d]);
  }
}

// The arm sags until its drives bear the weight: stiffness * sag is what gravity does to the joint.
TEST(StatedGains, AnArmHoldsItsPostureByThem) {
  Robot robot = find_robot("puma560");
  for (Joint& joint : robot.joints) joint.friction = {};
  World world;
  world.robots = {robot_at_start(robot)};
  WorldRobot& arm = world.robots[0];
  const RobotModel& model = *arm.model;
  const PdGains gains = stated_gains(arm);
  EXPECT_EQ(gains.stiffness[1], 10000.0);
  EXPECT_EQ(gains.stiffness[5], 100.0);
  const Eigen::VectorXd wanted = set_points(model.robot);
  arm.drives = pd_drives(model, gains, wanted);
  EXPECT_EQ(arm.drives[1].max_effort, 186.4);
  hold(world, 2.0);
  RobotSurroundings around;
  around.gravity_B = world.gravity;
  const Eigen::VectorXd weight =
      model.dynamics->bias(joints_of(arm), Eigen::VectorXd::Zero(6), around);
  const Eigen::VectorXd sag = wanted - arm.x;
  EXPECT_GT(sag.cwiseAbs().maxCoeff(), 1e-4);
  EXPECT_LT((gains.stiffness.cwiseProduct(sag) - weight).norm(), 1e-6 * weight.norm());
}

TEST(StatedGains, AHandGoesToAPreshape) {
  World world;
  world.gravity.setZero();
  world.robots = {robot_at_start(find_robot("barrett"))};
  WorldRobot& hand = world.robots[0];
  const Eigen::VectorXd wanted = set_points(hand.model->robot, "spread_45");
  EXPECT_NEAR(wanted[0], 0.25 * std::acos(-1.0), 1e-12);
  hand.drives = pd_drives(*hand.model, stated_gains(hand), wanted);
  hold(world, 1.0);
  EXPECT_LT((hand.x.head(4) - wanted).norm(), 1e-6);
}

TEST(StatedGains, WhatCannotBeIsRefused) {
  const WorldRobot hand = robot_at_start(find_robot("barrett"));
  const PdGains gains = stated_gains(hand);
  const auto field = [](const auto& call) { return test::refusal_of(call).field(); };
  EXPECT_EQ(field([&] { (void)stated_gains(hand, 0.0); }), "frequency");
  EXPECT_EQ(field([&] { (void)set_points(hand.model->robot, "fist"); }), "preshapes");
  EXPECT_EQ(field([&] { (void)pd_drives(*hand.model, gains, Eigen::VectorXd::Zero(3)); }),
            "values");
  EXPECT_EQ(field([&] { (void)pd_drives(*hand.model, {}, Eigen::VectorXd::Zero(4)); }),
            "stiffness");
}

}  // namespace
}  // namespace prehend
