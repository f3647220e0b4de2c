// The Puma 560 against a closed form, against numbers that another simulator printed, and its
// shape.
#include <cmath>

#include <gtest/gtest.h>

#include "sim/robot/files/robot_file.h"
#include "tests/sim/robot/files/reference_robot.h"
#include "tests/support/turns.h"

namespace prehend {
namespace {

constexpr const char* kPumaReference = "reference/graspit/fk/Puma560.json";

using Posture = std::vector<double>;

Posture degrees(Posture angles) {
  for (double& angle : angles) angle *= test::kDegree;
  return angles;
}

Matrix3 turn(double angle, const Vector3& axis) {
  return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
}

// The frame after the last joint, from the geometry of the arm: upper arm and forearm in a vertical
// plane beside the waist's axis, a ball-and-socket wrist behind them.
Pose closed_form(const Posture& q) {
  const double fold = q[1] + q[2];
  const double out = 0.4318 * std::cos(q[1]) + 0.0203 * std::cos(fold) - 0.4318 * std::sin(fold);
  const double up = 0.4318 * std::sin(q[1]) + 0.0203 * std::sin(fold) + 0.4318 * std::cos(fold);
  const Matrix3 waist = turn(q[0], Vector3::UnitZ());
  return pose_from(waist * turn(-fold, Vector3::UnitY()) * turn(q[3], Vector3::UnitZ()) *
                       turn(-q[4], Vector3::UnitY()) * turn(q[5], Vector3::UnitZ()),
                   waist * Vector3(out, -0.149, up));
}

TEST(Puma560, AtZeroTheForearmStandsUp) {
  const Robot robot = find_robot("puma560");
  const Pose expected = translation(Vector3(0.4521, -0.149, 0.4318));
  test::expect_same_pose(test::poses_at(robot, Posture(6, 0.0)).back(), expected, 1e-12);
}

TEST(Puma560, ForwardKinematicsAreTheClosedForm) {
  const Robot robot = find_robot("puma560");
  for (const Posture& posture :
       {Posture{0, 90, -90, 0, 0, 0}, Posture{0, 45, -180, 0, 45, 0}, Posture{30, 0, 0, 0, 0, 0},
        Posture{-150, 200, -220, 100, -95, 210}, Posture{77, -33, 48, -121, 64, -199}}) {
    const Posture q = degrees(posture);
    test::expect_same_pose(test::poses_at(robot, q).back(), closed_form(q), 1e-12);
  }
}

TEST(Puma560, LinkPosesAgreeWithTheReference) {
  PREHEND_NEEDS_SHARED(kPumaReference);
  test::expect_link_poses_agree(find_robot("puma560"), test::reference(kPumaReference));
}

TEST(Puma560, LimitsAgreeWithTheReference) {
  PREHEND_NEEDS_SHARED(kPumaReference);
  test::expect_limits_agree(find_robot("puma560"), test::reference(kPumaReference));
}

// Within the differences that its README lists.
TEST(Puma560, LinkBoxesAgreeWithTheReference) {
  PREHEND_NEEDS_SHARED(kPumaReference);
  const Robot robot = find_robot("puma560");
  const nlohmann::json json = test::reference(kPumaReference);
  ASSERT_EQ(json["links"].size() + 1, robot.links.size());
  for (std::size_t l = 0; l < robot.links.size(); ++l) {
    const nlohmann::json& expected = l == 0 ? json["palm"] : json["links"][l - 1];
    const Bounds box = bounds(robot.links[l].mesh);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto axis = static_cast<Eigen::Index>(k);
      const double tolerance = robot.links[l].name == "shoulder_drum" ? 12.5 : 6.0;
      EXPECT_NEAR(1e3 * box.lower[axis], expected["aabb_min"][k].get<double>(), tolerance);
      EXPECT_NEAR(1e3 * box.upper[axis], expected["aabb_max"][k].get<double>(), tolerance);
    }
  }
}

TEST(Puma560, StartsFarFromItsLimitsWithTheHandForwardAndDown) {
  const Robot robot = find_robot("puma560");
  for (const DegreeOfFreedom& dof : robot.dofs) {
    EXPECT_GT(dof.initial - dof.lower, 40.0 * test::kDegree) << dof.name;
    EXPECT_GT(dof.upper - dof.initial, 40.0 * test::kDegree) << dof.name;
  }
  const Pose X_BF = test::poses_at(robot, initial_dofs(robot)).back();
  const Vector3 approach = X_BF.linear().col(2);
  EXPECT_LT((approach - Vector3(std::sqrt(0.5), 0.0, -std::sqrt(0.5))).norm(), 1e-9);
}

TEST(Puma560, OrdinaryPosturesAreFreeOfSelfCollision) {
  const Robot robot = find_robot("puma560");
  for (const Posture& posture :
       {Posture{0, 0, 0, 0, 0, 0}, Posture{0, 90, -90, 0, 0, 0}, Posture{0, 0, -90, 0, 0, 0},
        Posture{0, 45, -180, 0, 45, 0}, Posture{90, 60, -190, 45, -60, 90},
        Posture{0, -35, -60, 0, -80, 0}, Posture{0, 180, 0, 0, 60, 0}, Posture{0, 90, 51, 0, 0, 0},
        Posture{0, 90, -231, 90, 99, 0}, Posture{0, 90, -90, 109, -99, 0}}) {
    EXPECT_EQ(test::self_collisions(robot, degrees(posture)), "")
        << posture[1] << " " << posture[2];
  }
}

TEST(Puma560, AHandBetweenTheFeetHitsThePedestal) {
  const Robot robot = find_robot("puma560");
  const std::string hits = test::self_collisions(robot, degrees({-133, -34, -163, -121, -85, -86}));
  EXPECT_NE(hits.find("pedestal-"), std::string::npos) << hits;
}

TEST(Puma560, IsSolvedInClosedForm) {
  const Robot robot = find_robot("puma560");
  ASSERT_EQ(robot.chains.size(), 1U);
  EXPECT_EQ(robot.chains[0].closed_form, ClosedForm::spherical_wrist);
}

TEST(Puma560, SpeedsAreReadInRadians) {
  const Robot robot = find_robot("puma560");
  EXPECT_NEAR(robot.dofs[0].max_velocity, 82.0 * test::kDegree, 1e-12);
  EXPECT_NEAR(robot.dofs[0].max_acceleration, 205.0 * test::kDegree, 1e-12);
}

}  // namespace
}  // namespace prehend
