#include <cmath>

#include <gtest/gtest.h>

#include "sim/motion/energy.h"
#include "sim/motion/require_world.h"
#include "sim/motion/robot_dynamics.h"
#include "sim/motion/step_world.h"
#include "sim/motion/world.h"
#include "sim/robot/files/robot_file.h"
#include "sim/shape/basic_shapes.h"
#include "tests/support/refusal_of.h"

namespace prehend {
namespace {

constexpr double kWeight = 9.81;  // [m/s^2]

// A rod that hangs from a joint about y, its mass spread over its length.
Robot pendulum(double length, double mass) {
  Robot robot;
  robot.name = "pendulum";
  Joint joint{.name = "hinge"};
  joint.axis = Vector3::UnitY();
  joint.lower = -10.0;
  joint.upper = 10.0;
  robot.joints = {joint};
  robot.dofs = {{.name = "hinge", .lower = -10.0, .upper = 10.0}};
  Link base;
  base.name = "base";
  base.material = "metal";
  base.mesh = make_box(Vector3::Constant(0.01));
  Link rod;
  rod.name = "rod";
  rod.material = "metal";
  rod.joint = 0;
  rod.mesh = make_box({0.01, 0.01, length});
  for (Vector3& p : rod.mesh.vertices) p.z() -= 0.5 * length + 0.02;
  rod.inertial = inertial_of_mass(rod.mesh, mass);
  robot.links = {base, rod};
  robot.chains = {{"arm", 0, 1}};
  return robot;
}

World world_with_robot(const Robot& robot, const std::vector<double>& dofs) {
  World world;
  auto model = std::make_shared<const RobotModel>(make_robot_model(robot));
  world.robots.push_back(make_world_robot(robot.name, model, Pose::Identity(), dofs));
  return world;
}

void run_all(World& world, double seconds, double step) {
  for (double time = 0.0; time < seconds - 1e-12;) {
    const StepResult result = step_world(world, {.step = std::min(step, seconds - time)});
    ASSERT_EQ(result.outcome, StepOutcome::moved);
    time += result.time;
  }
}

// The exact motion by the classical Runge-Kutta method with steps so small that its error does not
// show.
double swung(double length, double angle, double seconds) {
  const double center = 0.5 * length + 0.02;
  const double inertia = length * length / 12.0 + 0.01 * 0.01 / 12.0 + center * center;
  const auto slope = [&](double a) { return -kWeight * center / inertia * std::sin(a); };
  const int steps = 20000;
  const double h = seconds / steps;
  double rate = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double k1 = slope(angle);
    const double k2 = slope(angle + 0.5 * h * rate);
    const double k3 = slope(angle + 0.5 * h * (rate + 0.5 * h * k1));
    const double k4 = slope(angle + h * (rate + 0.5 * h * k2));
    angle += h * (rate + h / 6.0 * (k1 + k2 + k3));
    rate += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
  }
  return angle;
}

TEST(WorldRobot, APendulumSwingsAsItShould) {
  const double exact = swung(0.3, 1.0, 1.0);
  double last = 0.0;
  for (const double step : {2e-3, 1e-3, 5e-4}) {
    World world = world_with_robot(pendulum(0.3, 0.5), {1.0});
    run_all(world, 1.0, step);
    const double error = std::abs(world.robots[0].x[0] - exact);
    if (last > 0.0) {
      EXPECT_NEAR(last / error, 4.0, 0.4);  // of second order
    }
    last = error;
  }
  EXPECT_LT(last, 1e-6);
}

Robot double_pendulum() {
  Robot robot = pendulum(0.3, 0.5);
  Joint elbow = robot.joints[0];
  elbow.name = "elbow";
  elbow.parent = 0;
  elbow.dof = 1;
  elbow.X_PJ = translation({0.0, 0.0, -0.34});
  robot.joints.push_back(elbow);
  robot.dofs.push_back({.name = "elbow", .lower = -10.0, .upper = 10.0});
  Link rod = robot.links[1];
  rod.name = "second rod";
  rod.joint = 1;
  robot.links.push_back(rod);
  robot.chains[0].joint_count = 2;
  return robot;
}

// By the classical Runge-Kutta method on the accelerations of articulated bodies.
Eigen::VectorXd swung_double(const RobotDynamics& dynamics, Eigen::VectorXd q, double seconds) {
  RobotSurroundings around;
  around.gravity_B = Vector3(0.0, 0.0, -kWeight);
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(2);
  const auto slope = [&](const Eigen::VectorXd& at,
                         const Eigen::VectorXd& rate) -> Eigen::VectorXd {
    return dynamics.forward(at, rate, none, around);
  };
  const int steps = 2000;
  const double h = seconds / steps;
  Eigen::VectorXd v = none;
  for (int i = 0; i < steps; ++i) {
    const Eigen::VectorXd k1 = slope(q, v);
    const Eigen::VectorXd k2 = slope(q + 0.5 * h * v, v + 0.5 * h * k1);
    const Eigen::VectorXd k3 = slope(q + 0.5 * h * (v + 0.5 * h * k1), v + 0.5 * h * k2);
    const Eigen::VectorXd k4 = slope(q + h * (v + 0.5 * h * k2), v + h * k3);
    q += h * (v + h / 6.0 * (k1 + k2 + k3));
    v += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
  }
  return q;
}

TEST(WorldRobot, ADoublePendulumSwingsAsItShould) {
  const Eigen::Vector2d start(0.8, -0.5);
  double last = 0.0;
  for (const double step : {2e-3, 1e-3, 5e-4}) {
    World world = world_with_robot(double_pendulum(), {start[0], start[1]});
    run_all(world, 1.0, step);
    const Eigen::VectorXd exact = swung_double(*world.robots[0].model->dynamics, start, 1.0);
    const double error = (world.robots[0].x - exact).norm();
    if (last > 0.0) {
      EXPECT_NEAR(last / error, 4.0, 0.4);  // of second order
    }
    last = error;
  }
  EXPECT_LT(last, 1e-5);
}

// What swings freely keeps its energy: 3 s of a double pendulum, and an arm that falls until its
// links hit each other, at the default step.
TEST(WorldRobot, WhatSwingsFreelyKeepsItsEnergy) {
  World pendulum = world_with_robot(double_pendulum(), {1.5, -0.5});
  World arm = world_with_robot(find_robot("ur5e"), {0.2, -1.2, 1.4, 0.3, 0.7, 0.1});
  for (auto& [world, seconds] : {std::pair{&pendulum, 3.0}, std::pair{&arm, 0.85}}) {
    const double start = energy_of(*world);
    double off = 0.0;
    double moving = 0.0;  // [J]
    for (double time = 0.0; time < seconds; time += StepOptions{}.step) {
      ASSERT_EQ(step_world(*world).outcome, StepOutcome::moved);
      off = std::max(off, std::abs(energy_of(*world) - start));
      const WorldRobot& robot = world->robots[0];
      const RobotModel& model = *robot.model;
      moving = std::max(
          moving, model.dynamics->kinetic_energy(joints_of(robot), model.joints_of * robot.rate));
    }
    EXPECT_GT(moving, 1.0);
    EXPECT_LT(off, 2e-3 * moving) << world->robots[0].name;
    RecordProperty(world->robots[0].name, std::to_string(off) + " of " + std::to_string(moving));
  }
}

TEST(WorldRobot, ADriveHoldsUpToItsEffort) {
  const double center = 0.5 * 0.3 + 0.02;
  const double moment = 0.5 * kWeight * center;  // of the rod held level
  for (const double part : {1.05, 0.95}) {
    World world = world_with_robot(pendulum(0.3, 0.5), {0.5 * std::acos(-1.0)});
    world.robots[0].drives = {{.dof = 0, .holds_rate = true, .max_effort = part * moment}};
    run_all(world, 0.2, 2.5e-3);
    const double moved = std::abs(world.robots[0].x[0] - 0.5 * std::acos(-1.0));
    if (part > 1.0) {
      EXPECT_LT(moved, 1e-9);
    } else {
      EXPECT_GT(moved, 0.01);
    }
  }
}

TEST(WorldRobot, ASpringSettlesWhereItBalancesTheWeight) {
  World world = world_with_robot(pendulum(0.3, 0.5), {0.0});
  world.robots[0].drives = {{.dof = 0, .stiffness = 5.0, .damping = 1.0, .target = 0.5}};
  run_all(world, 10.0, 2.5e-3);
  const double at = world.robots[0].x[0];
  EXPECT_NEAR(5.0 * (0.5 - at), 0.5 * kWeight * (0.5 * 0.3 + 0.02) * std::sin(at), 1e-9);
}

TEST(WorldRobot, ALimitStopsTheJoint) {
  Robot robot = pendulum(0.3, 0.5);
  robot.joints[0].lower = 0.3;
  World world = world_with_robot(robot, {1.0});
  run_all(world, 3.0, 2.5e-3);
  EXPECT_NEAR(world.robots[0].x[0], 0.3, 1e-9);
  EXPECT_NEAR(world.robots[0].rate[0], 0.0, 1e-12);
}

TEST(WorldRobot, DryFrictionHoldsAHangingRodBelowItsMoment) {
  Robot robot = pendulum(0.3, 0.5);
  const double moment = 0.5 * kWeight * (0.5 * 0.3 + 0.02);
  robot.joints[0].friction.coulomb = 0.5 * moment;
  for (const double angle : {0.45, 0.6}) {  // sin: 0.435, 0.565
    World world = world_with_robot(robot, {angle});
    run_all(world, 0.2, 2.5e-3);
    if (angle < 0.5) {
      EXPECT_NEAR(world.robots[0].x[0], angle, 1e-12);
    } else {
      EXPECT_LT(world.robots[0].x[0], angle - 1e-4);
    }
  }
}

// The clutches of the Barrett hand: a finger whose first joint is stopped goes on with its last,
// whose cables begin in the palm: 125 turns of the motor turn the first link once and the last one
// 4/3 times as seen from the palm (Barrett, BH8-280 kinematics), whether the clutch slips or not.
TEST(WorldRobot, AClutchLetsTheFingertipGoOn) {
  const Robot barrett = find_robot("barrett");
  const auto model = std::make_shared<const RobotModel>(make_robot_model(barrett));
  ASSERT_EQ(model->clutches.size(), 3U);
  EXPECT_EQ(model->coordinates(), 7);
  World world;
  world.gravity.setZero();
  world.robots.push_back(
      make_world_robot("barrett", model, Pose::Identity(), std::vector<double>(4, 0.0)));
  // A post in front of the first link of the thumb, far from its tip.
  WorldBody post{"post", make_collision_body("post", make_box({0.3, 0.01, 0.01}), true)};
  post.is_fixed = true;
  post.motion.X_WB = translation({0.0, -0.05, 0.05});
  world.bodies.push_back(post);
  world.robots[0].drives = {{.dof = 3, .target_rate = 1.0, .holds_rate = true, .max_effort = 5.0}};
  run_all(world, 1.2, 2.5e-3);
  const Eigen::VectorXd q = joints_of(world.robots[0]);
  const WorldRobot& robot = world.robots[0];
  EXPECT_LT(robot.x[6], -0.05);                            // the clutch of the thumb has slipped
  EXPECT_NEAR(q[6] + q[7], 4.0 / 3.0 * robot.x[3], 1e-9);  // its last link follows the drive
  EXPECT_NEAR(q[6], robot.x[3] + robot.x[6], 1e-9);
  // Joints say where drive and clutch are.
  const std::vector<double> joints(q.data(), q.data() + q.size());
  const Eigen::VectorXd x = coordinates_at(*model, std::vector<double>(4, 0.0), joints);
  EXPECT_LT((x - robot.x).norm(), 1e-9);
}

// A finger of two links whose first one can break away, 0.1 m each, that closes about y.
Robot breakaway_finger(double effort, double clutch) {
  Robot robot = pendulum(0.1, 0.05);
  robot.joints[0].lower = -0.01;
  robot.joints[0].max_effort = effort;
  Joint tip = robot.joints[0];
  tip.name = "tip";
  tip.parent = 0;
  tip.ratio = 1.0 / 3.0;
  tip.upper = 1.0;
  tip.max_effort = 0.0;
  tip.X_PJ = translation({0.0, 0.0, -0.14});
  robot.joints.push_back(tip);
  robot.dofs[0] = {.name = "finger", .lower = -0.01, .upper = 3.0, .closing_velocity = 1.0};
  robot.dofs[0].coupling = Coupling::breakaway;
  robot.dofs[0].breakaway_effort = clutch;
  Link rod = robot.links[1];
  rod.name = "tip";
  rod.joint = 1;
  robot.links.push_back(rod);
  robot.chains[0].joint_count = 2;
  return robot;
}

// The torque about its joint with which the finger presses on a block that stops its first link
// 75 mm from there.
double torque_on_block(const Robot& finger, double effort, double step) {
  World world = world_with_robot(finger, {0.0});
  world.gravity.setZero();
  WorldBody block{"block", make_collision_body("block", make_box({0.02, 0.1, 0.001}), true)};
  block.is_fixed = true;
  block.motion.X_WB = translation({-0.03, 0.0, -0.075});
  world.bodies.push_back(block);
  world.robots[0].drives = {
      {.dof = 0, .target_rate = 1.0, .holds_rate = true, .max_effort = effort}};
  run_all(world, 3.0, step);
  double torque = 0.0;
  for (const WorldContact& contact : world.contacts) {
    torque += contact.position_W.cross(contact.impulse_W).y() / world.last_step;
  }
  return std::abs(torque);
}

// The tip has gone on to its stop, and the drive presses with all it has: on the block through the
// clutch, and not with more from one step to the next.
TEST(WorldRobot, AGearDoesNotPressOnWhatStopsItsFinger) {
  const Robot finger = breakaway_finger(0.6, 0.4);
  for (const double step : {2.5e-3, 1e-3, 5e-4, 2.5e-4}) {
    EXPECT_NEAR(torque_on_block(finger, 0.6, step), 0.4, 1e-3) << step;
  }
}

// Pushed back, the finger holds a third more than its drive presses with, and gives way beyond.
TEST(WorldRobot, AGearHoldsAThirdMoreThanItsDrive) {
  Robot finger = breakaway_finger(0.6, 0.4);
  finger.links[2].inertial = inertial_of_mass(finger.links[2].mesh, 1e-5);
  for (const double part : {0.97, 1.03}) {
    World world = world_with_robot(finger, {0.5});
    // A weight of 50 g at 70 mm, where it pulls across the finger.
    const double pull = part * 4.0 / 3.0 * 0.6 / (0.05 * 0.07);
    world.robots[0].drives = {{.dof = 0, .holds_rate = true, .max_effort = 0.6}};
    for (int tenths = 1; tenths <= 13; ++tenths) {
      world.gravity =
          std::min(0.1 * tenths, 1.0) * pull * Vector3(std::cos(0.5), 0.0, -std::sin(0.5));
      run_all(world, 0.1, 2.5e-3);
    }
    const double way = 0.5 - joints_of(world.robots[0])[0];
    if (part < 1.0) {
      EXPECT_NEAR(way, 0.0, 0.011);
    } else {
      EXPECT_GT(way, 0.05);
    }
  }
}

// The same finger on a linkage, whose tip stays parallel until the first link is stopped.
Robot linkage_finger() {
  Robot finger = breakaway_finger(0.6, 0.0);
  finger.dofs[0].coupling = Coupling::by_finger;
  finger.dofs[0].upper = 1.0;
  finger.joints[1].ratio = -1.0;
  finger.joints[1].lower = -2.0;
  finger.joints[1].upper = 2.0;
  finger.joints[1].across = 0;
  finger.joints[1].ahead = 2.5;
  return finger;
}

TEST(WorldRobot, ALinkageTurnsTheTipInWhenItsFirstLinkIsStopped) {
  World world = world_with_robot(linkage_finger(), {0.0});
  world.gravity.setZero();
  WorldBody block{"block", make_collision_body("block", make_box({0.02, 0.1, 0.01}), true)};
  block.is_fixed = true;
  block.motion.X_WB = translation({-0.03, 0.0, -0.075});
  world.bodies.push_back(block);
  world.robots[0].drives = {{.dof = 0, .target_rate = 1.0, .holds_rate = true, .max_effort = 0.6}};
  run_all(world, 0.9, 2.5e-3);
  const WorldRobot& robot = world.robots[0];
  const Eigen::VectorXd q = joints_of(robot);
  ASSERT_EQ(robot.x.size(), 3);  // drive, the whole finger, and what its first link falls behind
  const double drive = robot.x[0] + robot.x[1];
  EXPECT_LT(robot.x[2], -0.1);
  EXPECT_NEAR(q[0], drive + robot.x[2], 1e-9);
  EXPECT_NEAR(q[1], -drive - 2.5 * robot.x[2], 1e-9);
}

// Weight that pulls the first link the way that it closes does not take it ahead of its drive.
TEST(WorldRobot, AStopOfALinkageKeepsItsLinkFromGoingAhead) {
  for (const double pull : {1.0, -1.0}) {
    Robot finger = linkage_finger();
    finger.joints[0].lower = -1.0;
    finger.dofs[0].lower = -1.0;
    finger.links[2].inertial = inertial_of_mass(finger.links[2].mesh, 1e-4);
    World world = world_with_robot(finger, {0.0});
    world.gravity = {-pull * 5.0, 0.0, 0.0};  // on a link that hangs: about +y, as it closes
    world.robots[0].drives = {{.dof = 0, .holds_rate = true, .max_effort = 0.6}};
    run_all(world, 0.1, 1e-3);
    if (pull > 0.0) {
      EXPECT_NEAR(world.robots[0].x[2], 0.0, 1e-6);
    } else {
      EXPECT_LT(world.robots[0].x[2], -1e-2);
    }
  }
}

TEST(WorldRobot, WhatNoDriveMayBeIsRefused) {
  World world = world_with_robot(pendulum(0.3, 0.5), {0.0});
  world.robots[0].drives = {{.dof = 0, .stiffness = -1.0}};
  EXPECT_EQ(test::refusal_of([&] { require_world(world); }).field(), "pendulum");
  world.robots[0].drives = {{.dof = 0, .max_effort = -1.0}};
  EXPECT_EQ(test::refusal_of([&] { require_world(world); }).field(), "pendulum");
  world.robots[0].drives = {{.dof = 7}};
  EXPECT_EQ(test::refusal_of([&] { require_world(world); }).field(), "pendulum");
}

}  // namespace
}  // namespace prehend
