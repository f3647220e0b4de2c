#include <cmath>
#include <limits>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "sim/motion/control/joint_controllers.h"
#include "sim/motion/control/joint_motion.h"
#include "sim/motion/control/run_controlled.h"
#include "sim/motion/control/time_path.h"
#include "sim/motion/control/wrist_impedance.h"
#include "sim/motion/robot_dynamics.h"
#include "sim/robot/files/robot_file.h"
#include "tests/support/refusal_of.h"

namespace prehend {
namespace {

// An arm of six joints that stands bent, far from its limits and from itself.
class Arm : public ::testing::Test {
 protected:
  static std::vector<double> bent() { return {0.2, -1.2, 1.4, 0.3, 0.7, 0.1}; }

  static World at(const std::vector<double>& dofs) {
    static const auto kModel =
        std::make_shared<const RobotModel>(make_robot_model(find_robot("ur5e")));
    World world;
    world.robots.push_back(make_world_robot("arm", kModel, Pose::Identity(), dofs));
    return world;
  }

  static const RobotModel& model_of(const World& world) { return *world.robots[0].model; }

  // All joints turn by `angle` and come to rest, at 1.5 rad/s and 4 rad/s^2 at most.
  static JointMotion turned_by(double angle, const World& world) {
    std::vector<double> to = bent();
    for (double& value : to) value += angle;
    const JointLimits limits{std::vector<double>(6, 1.5), std::vector<double>(6, 4.0)};
    Trajectory trajectory;
    const Robot& robot = model_of(world).robot;
    for (const DegreeOfFreedom& dof : robot.dofs) trajectory.joints.push_back(dof.name);
    append(trajectory, "move", time_path({bent(), to}, PathKind::corners, limits));
    return motion_along(trajectory, robot, world.robots[0].x);
  }

  // How far the arm is from the motion at most [rad].
  static double farthest(World& world, const Controller& controller, const JointMotion& motion) {
    double worst = 0.0;
    ControlledRunOptions options{.seconds = 1.5};
    options.stops = [&](double time, const World& now) {
      const Eigen::VectorXd off = now.robots[0].x - motion(time);
      worst = std::max(worst, off.lpNorm<Eigen::Infinity>());
      return false;
    };
    const ControlledRun run = run_controlled(world, {{0, controller}}, options);
    EXPECT_EQ(run.outcome, ControlOutcome::finished);
    EXPECT_NEAR(run.time, 1.5, 1e-9);
    return worst;
  }
};

// What PD control lags behind, feed-forward by the equation of motion supplies.
TEST_F(Arm, ComputedTorqueFollowsWhatPdAloneDoesNot) {
  World world = at(bent());
  const JointMotion motion = turned_by(0.8, world);
  const PdGains gains = critically_damped(world.robots[0], 3.0);
  World by_pd = world;
  const double pd = farthest(by_pd, pd_controller(model_of(world), gains, motion), motion);
  World balanced = world;
  const double with_gravity = farthest(
      balanced, sum_of({gravity_compensation(), pd_controller(model_of(world), gains, motion)}),
      motion);
  const double computed = farthest(world, computed_torque(motion, 3.0), motion);
  EXPECT_GT(pd, 0.02);
  EXPECT_LT(with_gravity, pd);
  EXPECT_GT(with_gravity, 1e-3);
  EXPECT_LT(computed, 1e-4);
  RecordProperty("pd", std::to_string(pd));
  RecordProperty("with_gravity", std::to_string(with_gravity));
  RecordProperty("computed", std::to_string(computed));
}

// A critically damped return: (1 + w t) exp(-w t) of where it was.
TEST_F(Arm, ComputedTorqueReturnsToTheMotionItHasLeft) {
  World world = at(bent());
  const Eigen::VectorXd target = world.robots[0].x.array() - 0.05;
  const Controller controller =
      computed_torque([&](double) -> Eigen::VectorXd { return target; }, 2.0);
  ControlledRunOptions options{.seconds = 0.2};
  options.step.step = 1e-3;
  EXPECT_EQ(run_controlled(world, {{0, controller}}, options).outcome, ControlOutcome::finished);
  const double wt = 2.0 * std::acos(-1.0) * 2.0 * 0.2;
  const double left = 0.05 * (1.0 + wt) * std::exp(-wt);
  for (const double off : Eigen::VectorXd(world.robots[0].x - target)) {
    EXPECT_NEAR(off, left, 0.02 * 0.05);
  }
}

TEST_F(Arm, StandsStillWhereItsWeightIsCompensated) {
  World world = at(bent());
  const Eigen::VectorXd before = world.robots[0].x;
  const ControlledRun run = run_controlled(world, {{0, gravity_compensation()}});
  EXPECT_EQ(run.outcome, ControlOutcome::finished);
  EXPECT_LT((world.robots[0].x - before).norm(), 1e-9);
}

// Springs in its joints are part of what is compensated: the arm stands, and moves, as without
// them.
TEST_F(Arm, SpringsOfJointsAreCompensated) {
  Robot robot = find_robot("ur5e");
  for (std::size_t j = 0; j < 3; ++j) {
    robot.joints[j].spring = {.stiffness = 50.0, .rest = 0.3};
    robot.joints[j].max_effort = 0.0;  // not said: none is too much
  }
  World world;
  world.robots.push_back(
      make_world_robot("arm", std::make_shared<const RobotModel>(make_robot_model(robot)),
                       Pose::Identity(), bent()));
  World standing = world;
  const Eigen::VectorXd before = standing.robots[0].x;
  EXPECT_EQ(run_controlled(standing, {{0, gravity_compensation()}}).outcome,
            ControlOutcome::finished);
  EXPECT_LT((standing.robots[0].x - before).norm(), 1e-9);
  const JointMotion motion = turned_by(0.8, world);
  // What is asked for a whole step also acts in those that the world makes shorter.
  EXPECT_LT(farthest(world, computed_torque(motion, 3.0), motion), 1e-3);
}

// The wrist comes to rest where its springs balance a force: here what a sideways part of gravity,
// of which the controller does not know, does to the links.
TEST_F(Arm, AWristOnSpringsGivesWayByForceOverStiffness) {
  World world = at(bent());
  const Pose X_WT = [&] {
    std::vector<Pose> X_BJ;
    joint_poses(model_of(world).robot, bent(), X_BJ);
    return X_BJ[5];
  }();
  const Controller spring = wrist_impedance(model_of(world), 5, X_WT);
  const Vector3 known = world.gravity;
  world.gravity += Vector3(0.4, 0.3, 0.0);
  const Controller unaware = [&](const ControlState& state) -> Eigen::VectorXd {
    return spring({state.time, state.step, state.robot, known});
  };
  ControlledRunOptions options{.seconds = 4.0};
  options.step.step = 1e-3;
  EXPECT_EQ(run_controlled(world, {{0, unaware}}, options).outcome, ControlOutcome::finished);
  const WorldRobot& robot = world.robots[0];
  EXPECT_LT(robot.rate.norm(), 1e-5);
  const RobotDynamics& dynamics = *model_of(world).dynamics;
  const JointVector none = JointVector::Zero(6);
  RobotSurroundings around;
  around.gravity_B = world.gravity - known;
  const JointVector borne = -dynamics.bias(joints_of(robot), none, around);
  const Vector6 wrench = frame_jacobian(robot, 5).transpose().partialPivLu().solve(borne);
  std::vector<Pose> X_BJ;
  joint_poses(model_of(world).robot, {robot.x.begin(), robot.x.end()}, X_BJ);
  const Vector3 moved = X_BJ[5].translation() - X_WT.translation();
  EXPECT_GT(moved.norm(), 1e-3);
  EXPECT_LT((moved - wrench.tail<3>() / 1000.0).norm(), 1e-3 * moved.norm());
}

TEST_F(Arm, TheJacobianIsThatOfTheMotion) {
  World world = at(bent());
  WorldRobot& robot = world.robots[0];
  const Eigen::MatrixXd J = frame_jacobian(robot, 5);
  constexpr double kStep = 1e-6;
  std::vector<Pose> before;
  joint_poses(robot.model->robot, bent(), before);
  for (Eigen::Index j = 0; j < 6; ++j) {
    std::vector<double> dofs = bent();
    dofs[static_cast<std::size_t>(j)] += kStep;
    std::vector<Pose> after;
    joint_poses(robot.model->robot, dofs, after);
    const Vector3 linear = (after[5].translation() - before[5].translation()) / kStep;
    const Eigen::AngleAxisd turn(Matrix3(after[5].linear() * before[5].linear().transpose()));
    const Vector3 angular = turn.angle() / kStep * turn.axis();
    EXPECT_LT((J.col(j) - spatial(angular, linear)).norm(), 1e-5) << j;
  }
}

TEST_F(Arm, AControllerWithoutANumberEndsTheRunThere) {
  World world = at(bent());
  const Controller weight = gravity_compensation();
  const Controller fails = [&](const ControlState& state) -> Eigen::VectorXd {
    Eigen::VectorXd efforts = weight(state);
    if (state.time > 0.0995) efforts[2] = std::numeric_limits<double>::quiet_NaN();
    return efforts;
  };
  const ControlledRun run = run_controlled(world, {{0, fails}});
  EXPECT_EQ(run.outcome, ControlOutcome::not_a_number);
  EXPECT_EQ(run.steps, 40);
  EXPECT_NEAR(run.time, 0.1, 1e-9);
  EXPECT_EQ(run.why, "arm: the controller answered an effort that is not a number at 0.1 s");
  EXPECT_TRUE(world.robots[0].x.allFinite());
  const ControlledRun five = run_controlled(
      world,
      {{0, [](const ControlState&) -> Eigen::VectorXd { return Eigen::VectorXd::Zero(5); }}});
  EXPECT_EQ(five.outcome, ControlOutcome::wrong_size);
  EXPECT_EQ(five.why, "arm: the controller answered 5 efforts for 6 at 0 s");
}

TEST_F(Arm, EffortsAreLimitedToWhatJointsState) {
  Robot robot = find_robot("ur5e");
  for (Joint& joint : robot.joints) joint.max_effort = 1.0;
  World world;
  world.robots.push_back(
      make_world_robot("arm", std::make_shared<const RobotModel>(make_robot_model(robot)),
                       Pose::Identity(), bent()));
  const double before = world.robots[0].x[1];
  const ControlledRun run = run_controlled(world, {{0, gravity_compensation()}},
                                           {.seconds = 0.2, .step = {}, .stops = {}});
  EXPECT_EQ(run.outcome, ControlOutcome::finished);
  EXPECT_GT(std::abs(world.robots[0].x[1] - before), 0.05);
  EXPECT_EQ(world.robots[0].effort.lpNorm<Eigen::Infinity>(), 1.0);
}

TEST_F(Arm, AMotionStandsStillBeforeAndAfterItsTrajectory) {
  const World world = at(bent());
  const JointMotion motion = turned_by(0.5, world);
  EXPECT_EQ(motion(-1.0), world.robots[0].x);
  const Eigen::VectorXd end = world.robots[0].x.array() + 0.5;
  EXPECT_LT((motion(100.0) - end).norm(), 1e-12);
  Trajectory unknown;
  unknown.joints = {"tail"};
  unknown.times = {0.0};
  unknown.positions = {{0.0}};
  unknown.velocities = {{0.0}};
  const Robot& robot = model_of(world).robot;
  EXPECT_EQ(test::refusal_of([&] { (void)motion_along(unknown, robot, end); }).field(), "joints");
  EXPECT_EQ(test::refusal_of([&] { (void)motion_along({}, robot, end); }).field(), "trajectory");
}

TEST_F(Arm, WhatNoControllerMayHaveIsRefused) {
  World world = at(bent());
  const RobotModel& model = model_of(world);
  const JointMotion still = [&](double) -> Eigen::VectorXd { return world.robots[0].x; };
  PdGains gains = critically_damped(world.robots[0], 3.0);
  gains.damping[3] = -1.0;
  const auto field = [](const std::function<void()>& call) {
    return test::refusal_of(call).field();
  };
  EXPECT_EQ(field([&] { (void)pd_controller(model, gains, still); }), "damping");
  gains.stiffness.resize(2);
  EXPECT_EQ(field([&] { (void)pd_controller(model, gains, still); }), "stiffness");
  EXPECT_EQ(field([&] { (void)computed_torque(still, 0.0); }), "frequency");
  EXPECT_EQ(field([&] { (void)wrist_impedance(model, 6, Pose::Identity()); }), "joint");
  EXPECT_EQ(field([&] { (void)wrist_impedance(model, 5, Pose::Identity(), {.stiffness = -1.0}); }),
            "stiffness");
  EXPECT_EQ(field([&] { (void)run_controlled(world, {{1, gravity_compensation()}}); }), "robot");
  EXPECT_EQ(
      field([&] { (void)run_controlled(world, {}, {.seconds = -1.0, .step = {}, .stops = {}}); }),
      "seconds");
}

}  // namespace
}  // namespace prehend
