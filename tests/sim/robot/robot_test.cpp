// Forward kinematics against closed forms.
#include "sim/robot/robot.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "sim/robot/denavit_hartenberg.h"

namespace prehend {
namespace {

// Sums of a few products of numbers up to 1: a few units in the last place.
constexpr double kPoseRounding = 1e-14;

Robot planar_arm(double first, double second) {
  Robot robot;
  robot.chains = {{.name = "arm", .first_joint = 0, .joint_count = 2}};
  robot.joints = {denavit_hartenberg({.name = "shoulder"}, {.a = first}),
                  denavit_hartenberg({.name = "elbow", .dof = 1}, {.a = second})};
  robot.joints[1].parent = 0;
  robot.dofs = {{.name = "q0"}, {.name = "q1"}};
  robot.links.resize(3);  // not in the order of their joints
  robot.links[1].joint = 1;
  robot.links[2].joint = 0;
  return robot;
}

Pose one_joint(const Joint& joint, double value) {
  Robot robot;
  robot.joints = {joint};
  robot.chains = {{.name = "chain", .first_joint = 0, .joint_count = 1}};
  std::vector<Pose> X_BJ;
  joint_poses(robot, {value}, X_BJ);
  return X_BJ[0];
}

TEST(ForwardKinematics, PlanarArmFollowsItsClosedForm) {
  const Robot robot = planar_arm(0.3, 0.2);
  std::vector<Pose> X_BL;
  for (int i = -4; i <= 4; ++i) {
    for (int k = -4; k <= 4; ++k) {
      const double q0 = 0.7 * i;
      const double q1 = 0.6 * k;
      link_poses(robot, {q0, q1}, X_BL);
      ASSERT_EQ(X_BL.size(), 3U);
      const Vector3 elbow(0.3 * std::cos(q0), 0.3 * std::sin(q0), 0.0);
      const Vector3 tip = elbow + 0.2 * Vector3(std::cos(q0 + q1), std::sin(q0 + q1), 0.0);
      EXPECT_LT((X_BL[0].matrix() - Pose::Identity().matrix()).norm(), kPoseRounding);
      EXPECT_LT((X_BL[1].translation() - tip).norm(), kPoseRounding);
      EXPECT_LT((X_BL[2].translation() - elbow).norm(), kPoseRounding);
      EXPECT_LT((X_BL[1].linear().col(0) - (tip - elbow) / 0.2).norm(), kPoseRounding);
    }
  }
}

TEST(ForwardKinematics, StandardDenavitHartenbergOrder) {
  const Joint joint =
      denavit_hartenberg({.name = "j"}, {.theta = 0.4, .d = 0.1, .a = 0.2, .alpha = -0.9});
  const Pose expected = Pose(Eigen::AngleAxisd(0.4 + 0.3, Vector3::UnitZ())) *
                        translation({0.0, 0.0, 0.1}) * translation({0.2, 0.0, 0.0}) *
                        Eigen::AngleAxisd(-0.9, Vector3::UnitX());
  EXPECT_LT((one_joint(joint, 0.3).matrix() - expected.matrix()).norm(), kPoseRounding);
}

TEST(ForwardKinematics, PrismaticJointSlidesAlongZOfTheFrameBefore) {
  const Joint joint = denavit_hartenberg({.name = "j", .type = JointType::prismatic},
                                         {.theta = 0.4, .d = 0.1, .a = 0.2, .alpha = -0.9});
  const Pose at_rest = one_joint(joint, 0.0);
  const Pose moved = one_joint(joint, 0.25);
  EXPECT_LT((moved.linear() - at_rest.linear()).norm(), kPoseRounding);
  EXPECT_LT((moved.translation() - at_rest.translation() - Vector3(0.0, 0.0, 0.25)).norm(),
            kPoseRounding);
}

TEST(ForwardKinematics, ChainsStartAtTheirOwnBase) {
  Robot robot = planar_arm(0.3, 0.2);
  robot.chains.push_back({.name = "second", .first_joint = 2, .joint_count = 1});
  const Pose X_BJ2 =
      translation({0.0, 0.0, 0.5}) * Eigen::AngleAxisd(std::numbers::pi / 2.0, Vector3::UnitY());
  robot.joints.push_back(
      {.name = "slide", .type = JointType::prismatic, .X_PJ = X_BJ2, .chain = 1});
  std::vector<Pose> X_BJ;
  joint_poses(robot, {0.0, 0.0, 0.07}, X_BJ);
  ASSERT_EQ(X_BJ.size(), 3U);
  EXPECT_LT((X_BJ[2].translation() - Vector3(0.07, 0.0, 0.5)).norm(), kPoseRounding);
  EXPECT_LT((X_BJ[1].translation() - Vector3(0.5, 0.0, 0.0)).norm(), kPoseRounding);
}

TEST(JointValues, AreLinearInTheDegreesOfFreedom) {
  Robot robot = planar_arm(0.3, 0.2);
  robot.joints[0].ratio = -2.0;
  robot.joints[1].dof = 0;
  robot.joints[1].ratio = 1.0 / 3.0;
  robot.joints[1].offset = 0.1;
  const std::vector<double> values = joint_values(robot, {0.6, 99.0});
  ASSERT_EQ(values.size(), 2U);
  EXPECT_DOUBLE_EQ(values[0], -1.2);
  EXPECT_DOUBLE_EQ(values[1], 0.3);
}

}  // namespace
}  // namespace prehend
