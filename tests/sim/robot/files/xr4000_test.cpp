// The XR4000 base against a closed form and numbers that another simulator printed.
#include <array>

#include <gtest/gtest.h>

#include "sim/robot/files/robot_file.h"
#include "tests/sim/robot/files/reference_robot.h"

namespace prehend {
namespace {

constexpr const char* kXr4000Reference = "reference/graspit/fk/XR4000.json";

Pose drum_at(const Robot& robot, const std::vector<double>& dofs) {
  return test::poses_at(robot, dofs).back();
}

TEST(Xr4000, SlidesAlongXAndYAndTurnsAboutZ) {
  const Robot robot = find_robot("xr4000");
  for (const auto& [x, y, yaw] : {std::array{0.0, 0.0, 0.0}, std::array{2.5, 0.0, 0.0},
                                  std::array{0.0, 1.5, 0.0}, std::array{3.0, 99.0, -5.9}}) {
    const Pose expected = pose_from(Eigen::AngleAxisd(yaw, Vector3::UnitZ()).toRotationMatrix(),
                                    Vector3(x, y, 0.845));
    test::expect_same_pose(drum_at(robot, {x, y, yaw}), expected, 1e-12);
  }
}

TEST(Xr4000, PosesAgreeWithTheReference) {
  PREHEND_NEEDS_SHARED(kXr4000Reference);
  const Robot robot = find_robot("xr4000");
  const nlohmann::json json = test::reference(kXr4000Reference);
  ASSERT_EQ(json["poses"].size(), 5U);
  for (const nlohmann::json& pose : json["poses"]) {
    test::expect_same_pose(drum_at(robot, test::reference_dofs(robot, pose)),
                           test::pose_of(pose["links"][0]["pose"]), 1e-6);
  }
}

TEST(Xr4000, LimitsAgreeWithTheReference) {
  PREHEND_NEEDS_SHARED(kXr4000Reference);
  test::expect_limits_agree(find_robot("xr4000"), test::reference(kXr4000Reference));
}

TEST(Xr4000, TheDrumStandsClearOfTheFloorAndPassesOverTheMarker) {
  const Robot robot = find_robot("xr4000");
  ASSERT_EQ(robot.links.size(), 2U);
  const Bounds marker = bounds(robot.links[0].mesh);
  const Bounds drum = bounds(robot.links[1].mesh);
  EXPECT_GT(marker.lower.z(), 0.5e-3);
  EXPECT_LT(marker.upper.z() + 0.5e-3, 0.845 + drum.lower.z());
  EXPECT_EQ(test::self_collisions(robot, {0.0, 0.0, 0.0}), "");
  EXPECT_EQ(test::self_collisions(robot, {0.2, 0.1, 1.0}), "");
}

TEST(Xr4000, SpeedsAreReadInMetresAndRadians) {
  const Robot robot = find_robot("xr4000");
  EXPECT_NEAR(robot.dofs[0].max_velocity, 1.2, 1e-12);
  EXPECT_NEAR(robot.dofs[1].max_acceleration, 1.5, 1e-12);
  EXPECT_NEAR(robot.dofs[2].max_velocity, 2.0943951, 1e-6);
}

}  // namespace
}  // namespace prehend
