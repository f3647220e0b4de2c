// The closed form depends on the axes of an arm, not on how its joints are written.
#include "sim/robot/spherical_wrist.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "sim/base/random.h"
#include "sim/robot/files/robot_file.h"
#include "sim/robot/inverse_kinematics.h"

namespace prehend {
namespace {

// A frame on each axis of the arm, other than the one in which it is written: turned about the
// axis, pushed along it, then turned any way with the axis named in it; and a tool somewhere on the
// flange.
Robot rewritten(const Robot& arm, Random& random) {
  Robot robot = arm;
  Pose X_before = Pose::Identity();  // the frame of the rewritten joint before, in the old one
  for (std::size_t j = 0; j < arm.joints.size(); ++j) {
    Joint& joint = robot.joints[j];
    const Pose along = translation(random.uniform(-0.3, 0.3) * Vector3::UnitZ());
    const Pose on_axis = along * Eigen::AngleAxisd(random.uniform(-3.0, 3.0), Vector3::UnitZ());
    const Pose X_JK = on_axis * pose_from(random.rotation(), Vector3::Zero());
    joint.X_PJ = X_before.inverse() * arm.joints[j].X_PJ * X_JK;
    joint.axis = (X_JK.linear().transpose() * Vector3::UnitZ()).normalized();
    const Pose after = random.pose(0.3);
    joint.X_JA = X_JK.inverse() * arm.joints[j].X_JA * after;
    X_before = after;
  }
  return robot;
}

// Values that grow as the joint turns the other way about the opposite axis.
void turn_round(Joint& joint) {
  joint.axis = -joint.axis;
  joint.zero = -joint.zero;
  std::swap(joint.lower, joint.upper);
  joint.lower = -joint.lower;
  joint.upper = -joint.upper;
}

SphericalWrist::Joints random_joints(const Robot& robot, Random& random) {
  SphericalWrist::Joints values{};
  for (std::size_t k = 0; k < 6; ++k) {
    values[k] = random.uniform(robot.joints[k].lower, robot.joints[k].upper);
  }
  return values;
}

Pose tool_at(const Robot& robot, const SphericalWrist::Joints& values) {
  std::vector<Pose> X_BJ;
  joint_poses(robot, {values.begin(), values.end()}, X_BJ);
  return X_BJ[5];
}

void expect_solves(const Robot& robot, std::uint64_t seed) {
  ASSERT_EQ(spherical_wrist_defect(robot, robot.chains[0]), "");
  const SphericalWrist wrist(robot, robot.chains[0]);
  Random random(seed);
  int branches = 0;
  for (int i = 0; i < 100; ++i) {
    const SphericalWrist::Joints asked = random_joints(robot, random);
    const Pose X_BT = tool_at(robot, asked);
    const auto found = wrist.solve(wrist.X_PC().inverse() * X_BT, asked);
    bool recovered = false;
    for (int b = 0; b < found.count; ++b) {
      const auto& values = found.joints[static_cast<std::size_t>(b)];
      EXPECT_LT((tool_at(robot, values).matrix() - X_BT.matrix()).norm(), 1e-9);
      double apart = 0.0;
      for (std::size_t k = 0; k < 6; ++k) {
        apart = std::max(apart, std::abs(values[k] - asked[k]));
      }
      recovered = recovered || apart < 1e-6;
    }
    EXPECT_TRUE(recovered) << i;
    branches += found.count;
  }
  EXPECT_GT(branches, 150);
}

TEST(SphericalWristAxes, AnyFramesOnTheAxesDo) {
  const Robot puma = find_robot("puma560");
  Random random(321);
  for (std::uint64_t seed = 0; seed < 10; ++seed) expect_solves(rewritten(puma, random), seed);
}

TEST(SphericalWristAxes, AnyJointMayTurnTheOtherWay) {
  const Robot puma = find_robot("puma560");
  for (std::size_t k = 0; k < 6; ++k) {
    Robot robot = puma;
    turn_round(robot.joints[k]);
    expect_solves(robot, k);
  }
  Robot robot = puma;
  for (Joint& joint : robot.joints) turn_round(joint);
  expect_solves(robot, 9);
}

TEST(SphericalWristAxes, SolveAllUsesThemThroughTheChainsParent) {
  Random random(322);
  Robot robot = rewritten(find_robot("puma560"), random);
  robot.joints[0].X_PJ = random.pose(1.0) * robot.joints[0].X_PJ;
  const SphericalWrist::Joints asked = random_joints(robot, random);
  const Pose X_JT = random.pose(0.2);
  const DofValues start(6, 0.1);
  const auto found = solve_all(robot, {{5, X_JT, tool_at(robot, asked) * X_JT}}, start);
  ASSERT_FALSE(found.empty());
  for (const DofValues& values : found) {
    std::vector<Pose> X_BJ;
    joint_poses(robot, values, X_BJ);
    EXPECT_LT((X_BJ[5].matrix() - tool_at(robot, asked).matrix()).norm(), 1e-9);
  }
}

TEST(SphericalWristAxes, SaysWhichAxesDoNotFit) {
  const Robot puma = find_robot("puma560");
  const auto defect = [&](std::size_t k, const Pose& before) {
    Robot robot = puma;
    robot.joints[k].X_PJ = robot.joints[k].X_PJ * before;
    return spherical_wrist_defect(robot, robot.chains[0]);
  };
  const Pose aside = translation({0.01, 0.02, 0.03});
  const Pose askew(Eigen::AngleAxisd(0.1, Vector3(1.0, 2.0, 0.0).normalized()));
  EXPECT_EQ(defect(0, aside), "") << "the base may be anywhere";
  EXPECT_EQ(defect(1, aside),
            "the closed form needs the axes of joints 1 and 2 to meet at a right angle");
  EXPECT_EQ(defect(2, askew),
            "the closed form needs the axes of joints 2 and 3 to be parallel and apart");
  EXPECT_EQ(defect(2, aside), "") << "parallel still";
  EXPECT_EQ(defect(3, askew),
            "the closed form needs the axis of joint 4 at a right angle to that of joint 3");
  EXPECT_EQ(defect(4, aside),
            "the closed form needs the axes of joints 4, 5 and 6 to meet in a point");
  EXPECT_EQ(defect(5, aside),
            "the closed form needs the axes of joints 4, 5 and 6 to meet in a point");
  EXPECT_EQ(
      defect(5, askew),
      "the closed form needs the axis of joint 5 at a right angle to those of joints 4 and 6");
  Robot robot = puma;
  robot.joints[3].type = JointType::prismatic;
  EXPECT_EQ(spherical_wrist_defect(robot, robot.chains[0]),
            "the closed form needs revolute joints");
}

}  // namespace
}  // namespace prehend
