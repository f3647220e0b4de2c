// The arm UR5e: forward kinematics at postures that a ruler gives, and its closed form.
#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "sim/base/random.h"
#include "sim/robot/files/robot_file.h"
#include "sim/robot/inverse_kinematics.h"
#include "sim/robot/ur_arm.h"

namespace prehend {
namespace {

constexpr double kPi = std::numbers::pi;

Pose flange_at(const Robot& robot, const SixJoints& values) {
  std::vector<Pose> X_BJ;
  joint_poses(robot, {values.begin(), values.end()}, X_BJ);
  return X_BJ[5];
}

SixJoints random_posture(Random& random) {
  SixJoints values{};
  for (double& value : values) value = random.uniform(-2.0 * kPi, 2.0 * kPi);
  return values;
}

double off_by(const SixJoints& a, const SixJoints& b) {
  double largest = 0.0;
  for (std::size_t k = 0; k < 6; ++k) largest = std::max(largest, std::abs(a[k] - b[k]));
  return largest;
}

// All solutions bring the flange there inside the limits; the number of them, and how far the
// nearest one is from the posture that was asked [rad].
struct Found {
  int count = 0;
  double nearest = 10.0;
};

Found check_solutions(const Robot& robot, const SixJoints& asked) {
  const UrArm arm(robot, robot.chains[0]);
  const Pose X_BT = flange_at(robot, asked);
  const SixJointSolutions found = arm.solve(arm.X_PC().inverse() * X_BT, asked);
  Found summary{.count = found.count};
  for (int b = 0; b < found.count; ++b) {
    const SixJoints& values = found.joints[static_cast<std::size_t>(b)];
    EXPECT_LT((flange_at(robot, values).matrix() - X_BT.matrix()).norm(), 1e-9);
    for (const double value : values) EXPECT_LE(std::abs(value), 2.0 * kPi);
    summary.nearest = std::min(summary.nearest, off_by(values, asked));
  }
  return summary;
}

// The figures of the data sheet: the arm along -x, the flange to the side and below.
TEST(Ur5e, AtZeroTheArmIsStretchedAlongMinusX) {
  const Pose X_BT = flange_at(find_robot("ur5e"), {});
  const Vector3 expected(-0.425 - 0.3922, -0.1333 - 0.0996, 0.1625 - 0.0997);
  EXPECT_LT((X_BT.translation() - expected).norm(), 1e-12);
  EXPECT_LT((X_BT.linear().col(2) + Vector3::UnitY()).norm(), 1e-12);
}

TEST(Ur5e, StandsUprightWithTheShoulderAtMinusARightAngle) {
  const Pose X_BT = flange_at(find_robot("ur5e"), {0.0, -kPi / 2.0, 0.0, -kPi / 2.0, 0.0, 0.0});
  const Vector3 expected(0.0, -0.1333 - 0.0996, 0.1625 + 0.425 + 0.3922 + 0.0997);
  EXPECT_LT((X_BT.translation() - expected).norm(), 1e-12);
}

TEST(Ur5e, InitialPosturePointsTheFlangeDown) {
  const Robot robot = find_robot("ur5e");
  std::vector<Pose> X_BJ;
  joint_poses(robot, joint_values(robot, initial_dofs(robot)), X_BJ);
  EXPECT_LT((X_BJ[5].linear().col(2) + Vector3::UnitZ()).norm(), 1e-12);
}

TEST(UrArm, SolvesEveryReachablePose) {
  const Robot robot = find_robot("ur5e");
  ASSERT_EQ(robot.chains[0].closed_form, ClosedForm::ur);
  Random random(77);
  std::array<int, 9> by_count{};
  for (int i = 0; i < 5000; ++i) {
    const Found found = check_solutions(robot, random_posture(random));
    EXPECT_LE(found.nearest, 1e-6) << "the posture asked is not among the solutions, pose " << i;
    ++by_count[static_cast<std::size_t>(found.count)];
  }
  EXPECT_GT(by_count[8], 1000);
}

TEST(UrArm, NearTheSingularWristPosesAreStillExact) {
  const Robot robot = find_robot("ur5e");
  Random random(78);
  for (const double bend : {1e-12, 1e-10, 1e-8, 1e-6, 1e-4}) {
    for (int i = 0; i < 200; ++i) {
      SixJoints asked = random_posture(random);
      asked[4] = (i % 2 == 0 ? 0.0 : kPi) + bend;
      EXPECT_GE(check_solutions(robot, asked).count, 1);
    }
  }
}

TEST(UrArm, AStraightWristKeepsItsLastJoint) {
  const Robot robot = find_robot("ur5e");
  const SixJoints asked = {0.3, -1.2, 1.1, -0.7, 0.0, 2.5};
  EXPECT_LE(check_solutions(robot, asked).nearest, 1e-7);
}

TEST(UrArm, AStretchedElbowIsSolved) {
  const Robot robot = find_robot("ur5e");
  Random random(79);
  for (int i = 0; i < 200; ++i) {
    SixJoints asked = random_posture(random);
    asked[2] = 0.0;
    EXPECT_LE(check_solutions(robot, asked).nearest, 1e-6);
  }
}

TEST(UrArm, SolveAllUsesIt) {
  const Robot robot = find_robot("ur5e");
  const SixJoints asked = {0.4, -1.3, 1.5, -1.0, -1.2, 0.5};
  const DofValues start(asked.begin(), asked.end());
  const auto found = solve_all(robot, {{5, Pose::Identity(), flange_at(robot, asked)}}, start);
  ASSERT_EQ(found.size(), 8U);
  for (std::size_t d = 0; d < 6; ++d) EXPECT_NEAR(found[0][d], asked[d], 1e-9);
}

TEST(UrArm, OutOfReachIsNoSolution) {
  const Robot robot = find_robot("ur5e");
  const UrArm arm(robot, robot.chains[0]);
  EXPECT_EQ(arm.solve(translation({1.3, 0.0, 0.0}), {}).count, 0);
  // Inside the cylinder about the first axis that the sideways offset keeps free.
  EXPECT_EQ(arm.solve(translation({0.0, 0.05, 0.6}), {}).count, 0);
}

// Only the axes count: frames moved along and turned about them, and joints that turn the other
// way.
TEST(UrArm, AnyFramesOnTheAxesDo) {
  const Robot arm = find_robot("ur5e");
  Random random(80);
  for (int i = 0; i < 100; ++i) {
    Robot robot = arm;
    Pose X_before = Pose::Identity();
    for (std::size_t j = 0; j < 6; ++j) {
      Joint& joint = robot.joints[j];
      const Pose along = translation(random.uniform(-0.3, 0.3) * Vector3::UnitZ());
      const Pose X_JK = along * pose_from(random.rotation(), Vector3::Zero());
      const double sense = random.uniform() < 0.5 ? -1.0 : 1.0;
      joint.X_PJ = X_before.inverse() * joint.X_PJ * X_JK;
      joint.axis = sense * (X_JK.linear().transpose() * Vector3::UnitZ()).normalized();
      joint.zero *= sense;
      const Pose after = random.pose(0.3);
      joint.X_JA = X_JK.inverse() * joint.X_JA * after;
      X_before = after;
    }
    ASSERT_EQ(ur_arm_defect(robot, robot.chains[0]), "");
    EXPECT_LE(check_solutions(robot, random_posture(random)).nearest, 1e-6);
  }
}

TEST(UrArm, SaysWhichAxesDoNotFit) {
  const auto defect = [](std::size_t k, const Pose& before) {
    Robot robot = find_robot("ur5e");
    robot.joints[k].X_PJ = robot.joints[k].X_PJ * before;
    return ur_arm_defect(robot, robot.chains[0]);
  };
  const Pose aside = translation({0.01, 0.02, 0.03});
  const Pose askew(Eigen::AngleAxisd(0.1, Vector3(1.0, 2.0, 0.0).normalized()));
  EXPECT_EQ(defect(0, aside), "") << "the base may be anywhere";
  EXPECT_NE(defect(1, aside).find("joints 1 and 2"), std::string::npos);
  EXPECT_EQ(defect(2, aside), "") << "parallel still";
  EXPECT_NE(defect(3, askew).find("joints 2, 3 and 4"), std::string::npos);
  EXPECT_NE(defect(4, aside).find("joints 4 and 5"), std::string::npos);
  EXPECT_NE(defect(5, askew).find("joints 5 and 6"), std::string::npos);
  const Robot puma = find_robot("puma560");
  EXPECT_NE(ur_arm_defect(puma, puma.chains[0]), "");
}

}  // namespace
}  // namespace prehend
