// The gripper 2F-85: pads that stay parallel, and its opening.
#include <gtest/gtest.h>

#include "sim/robot/files/robot_file.h"
#include "tests/sim/robot/files/hand_shape.h"

namespace prehend {
namespace {

// The bounds of a pad in the base frame at a value of the one degree of freedom.
Bounds pad_at(const Robot& robot, double grip, const std::string& name) {
  const std::vector<Pose> X_BL = test::poses_at(robot, {grip});
  for (std::size_t l = 0; l < robot.links.size(); ++l) {
    if (robot.links[l].name == name) return bounds(transformed(robot.links[l].mesh, X_BL[l]));
  }
  ADD_FAILURE() << "no link " << name;
  return {};
}

TEST(Robotiq2f85, PadsStayParallelAndSymmetricOverTheStroke) {
  const Robot robot = find_robot("robotiq_2f85");
  ASSERT_EQ(robot.dofs.size(), 1U);
  EXPECT_EQ(robot.dofs[0].coupling, Coupling::by_finger);
  double before = 1.0;
  for (int i = 0; i <= 20; ++i) {
    const double grip = robot.dofs[0].upper * i / 20.0;
    const Bounds left = pad_at(robot, grip, "left_pad");
    const Bounds right = pad_at(robot, grip, "right_pad");
    // A box that is not turned fills its bounds.
    EXPECT_LT((left.upper - left.lower - Vector3(0.005, 0.022, 0.0375)).norm(), 1e-12);
    EXPECT_LT((right.upper - right.lower - Vector3(0.005, 0.022, 0.0375)).norm(), 1e-12);
    EXPECT_NEAR(left.lower.x(), -right.upper.x(), 1e-12);
    EXPECT_NEAR(left.upper.z(), right.upper.z(), 1e-12);
    EXPECT_LT(left.lower.x(), before);
    before = left.lower.x();
  }
}

TEST(Robotiq2f85, OpensBy85MillimetresAndClosesToItsPublishedLength) {
  const Robot robot = find_robot("robotiq_2f85");
  EXPECT_NEAR(2.0 * pad_at(robot, 0.0, "left_pad").lower.x(), 0.085, 1e-9);
  const Bounds closed = pad_at(robot, robot.dofs[0].upper, "left_pad");
  EXPECT_GT(closed.lower.x(), 0.0);
  EXPECT_LT(closed.lower.x(), 2e-4);
  EXPECT_NEAR(closed.upper.z(), 0.1628, 5e-4);
}

// The second bar of each linkage turns as the first: its far end stays where the finger carries it.
TEST(Robotiq2f85, TheLinkageIsAParallelogram) {
  const Robot robot = find_robot("robotiq_2f85");
  for (const double grip : {0.0, 0.3, 0.8}) {
    std::vector<Pose> X_BJ;
    joint_poses(robot, joint_values(robot, {grip}), X_BJ);
    const Vector3 inner_pivot(0.0127, 0.0, 0.06142);
    const Vector3 bar = X_BJ[2].translation() - inner_pivot;
    EXPECT_NEAR(bar.norm(), Vector3(0.0376, 0.0, 0.043).norm(), 1e-9);
    EXPECT_LT((X_BJ[2].linear() - X_BJ[0].linear()).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace prehend
