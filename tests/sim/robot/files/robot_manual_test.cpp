// The robot printed in docs/reference/robot-file.md is a robot.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "sim/robot/files/platform_file.h"
#include "tests/sim/robot/files/robot_files.h"

namespace prehend {
namespace {

// Block `k` of JSON in docs/reference/robot-file.md.
std::string json_block(int k) {
  std::ifstream stream(std::filesystem::path(PREHEND_SOURCE_DIR) / "docs/reference/robot-file.md");
  const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  const std::string fence = "```json\n";
  std::size_t begin = 0;
  for (int i = 0; i <= k; ++i) {
    const std::size_t from = text.find(fence, begin);
    if (from == std::string::npos) return "";
    begin = from + fence.size();
  }
  return text.substr(begin, text.find("```", begin) - begin);
}

TEST(RobotManual, ItsExampleIsARobot) {
  const Robot robot = load_robot(test::write_robot_text(json_block(0)));
  EXPECT_EQ(robot.name, "vice");
  std::vector<Pose> X_BL;
  link_poses(robot, joint_values(robot, {0.06}), X_BL);
  const Bounds jaw = bounds(transformed(robot.links[1].mesh, X_BL[1]));
  EXPECT_NEAR(jaw.lower.x(), 0.04, 1e-12) << "60 mm from the fixed finger at x = -20 mm";
}

TEST(RobotManual, ItsForkBranches) {
  const Robot robot =
      load_robot(std::filesystem::path(PREHEND_SOURCE_DIR) / "docs/examples/fork.json");
  EXPECT_EQ(robot.name, "fork");
  ASSERT_EQ(robot.joints.size(), 3U);
  EXPECT_EQ(robot.joints[1].parent, 0);
  EXPECT_EQ(robot.joints[2].parent, 0);
  EXPECT_EQ(robot.joints[1].max_effort, 0.5);
  std::vector<Pose> X_BL;
  link_poses(robot, joint_values(robot, {0.0, std::numbers::pi / 2.0}), X_BL);
  const Bounds tip = bounds(transformed(robot.links[2].mesh, X_BL[2]));
  EXPECT_NEAR(tip.upper.y(), -0.020 + 0.040, 1e-12) << "bent towards y";
}

TEST(RobotManual, ItsPlatformIsAPlatform) {
  const std::filesystem::path file = test::write_robot_text(json_block(1));
  const std::filesystem::path vice = file.parent_path() / "vice.json";
  std::ofstream(vice) << json_block(0);
  const Platform platform = load_platform(file);
  EXPECT_EQ(platform.name, "arm_with_vice");
  EXPECT_EQ(hand_of(platform), 1);
  const AssembledPlatform assembled = assemble(platform);
  ASSERT_EQ(assembled.robot.dofs.size(), 7U);
  EXPECT_EQ(assembled.robot.dofs[0].name, "arm/waist");
  EXPECT_EQ(assembled.robot.dofs[6].name, "hand/opening");
  std::filesystem::remove(vice);
}

}  // namespace
}  // namespace prehend
