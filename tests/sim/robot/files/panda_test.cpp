// The arm of the Panda: forward kinematics at postures that a ruler gives, its published frames,
// and how well its redundant inverse kinematics serves.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "sim/base/random.h"
#include "sim/robot/files/platform_file.h"
#include "sim/robot/files/robot_file.h"
#include "sim/robot/inverse_kinematics.h"

namespace prehend {
namespace {

// Pose of the flange, 107 mm behind the last joint's frame.
Pose panda_flange(const Robot& robot, const DofValues& values) {
  std::vector<Pose> X_BJ;
  joint_poses(robot, joint_values(robot, values), X_BJ);
  return X_BJ[6] * translation({0.0, 0.0, 0.107});
}

TEST(PandaArm, AtZeroTheFlangeHangsInFrontOfTheColumn) {
  const Pose X_BF = panda_flange(find_robot("panda_arm"), DofValues(7, 0.0));
  EXPECT_LT((X_BF.translation() - Vector3(0.088, 0.0, 0.333 + 0.316 + 0.384 - 0.107)).norm(), 1e-9);
  EXPECT_LT((X_BF.linear().col(2) + Vector3::UnitZ()).norm(), 1e-9);
}

// The elbow bent by a right angle: the forearm points forward.
TEST(PandaArm, BendsItsElbowForward) {
  DofValues values(7, 0.0);
  values[3] = -std::numbers::pi / 2.0;
  const Pose X_BF = panda_flange(find_robot("panda_arm"), values);
  const Vector3 expected(0.0825 + 0.384 - 0.107, 0.0, 0.333 + 0.316 + 0.0825 - 0.088);
  EXPECT_LT((X_BF.translation() - expected).norm(), 1e-9);
}

// The published table of modified Denavit-Hartenberg parameters, multiplied out.
TEST(PandaArm, ForwardKinematicsAreThoseOfTheModifiedParameters) {
  const Robot robot = find_robot("panda_arm");
  constexpr double kRight = std::numbers::pi / 2.0;
  const double a[] = {0.0, 0.0, 0.0, 0.0825, -0.0825, 0.0, 0.088};
  const double d[] = {0.333, 0.0, 0.316, 0.0, 0.384, 0.0, 0.0};
  const double alpha[] = {0.0, -kRight, kRight, kRight, -kRight, kRight, kRight};
  Random random(5);
  for (int i = 0; i < 200; ++i) {
    DofValues values;
    Pose X_BJ = Pose::Identity();
    for (std::size_t k = 0; k < 7; ++k) {
      values.push_back(random.uniform(robot.dofs[k].lower, robot.dofs[k].upper));
      X_BJ = X_BJ * Eigen::AngleAxisd(alpha[k], Vector3::UnitX()) * translation({a[k], 0.0, 0.0}) *
             Eigen::AngleAxisd(values[k], Vector3::UnitZ()) * translation({0.0, 0.0, d[k]});
    }
    const Pose expected = X_BJ * translation({0.0, 0.0, 0.107});
    EXPECT_LT((panda_flange(robot, values).matrix() - expected.matrix()).norm(), 1e-9);
  }
}

TEST(Panda, CarriesItsHandAsPublished) {
  const Robot robot = assemble(find_platform("panda")).robot;
  std::vector<Pose> X_BL;
  DofValues values = initial_dofs(robot);
  link_poses(robot, joint_values(robot, values), X_BL);
  for (std::size_t l = 0; l < robot.links.size(); ++l) {
    if (robot.links[l].name != "hand/hand") continue;
    // The ready posture: the hand points down, its fingers open along y.
    EXPECT_LT((X_BL[l].linear().col(2) + Vector3::UnitZ()).norm(), 1e-5);
  }
}

// From the ready posture alone, poses of random postures are found, each exactly.
TEST(PandaArm, RedundantInverseKinematicsReachesRandomPoses) {
  const Robot robot = find_robot("panda_arm");
  Random random(6);
  int solved = 0;
  for (int i = 0; i < 200; ++i) {
    DofValues asked;
    for (const DegreeOfFreedom& dof : robot.dofs) {
      asked.push_back(random.uniform(dof.lower, dof.upper));
    }
    const Pose X_JT = translation({0.0, 0.0, 0.107});
    const Pose X_BT = panda_flange(robot, asked);
    IkOptions options;
    options.max_solutions = 1;
    const auto found = solve_all(robot, {{6, X_JT, X_BT}}, initial_dofs(robot), options);
    if (found.empty()) continue;
    ++solved;
    EXPECT_LT((panda_flange(robot, found[0]).matrix() - X_BT.matrix()).norm(), 1e-8);
  }
  EXPECT_GE(solved, 198);
}

}  // namespace
}  // namespace prehend
