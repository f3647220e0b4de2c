// The robot printed in docs/robot-file.md is a robot.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

#include "tests/robot/robot_files.h"

namespace prehend {
namespace {

std::string first_json_block(const std::filesystem::path& manual) {
  std::ifstream stream(manual);
  const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  const std::string fence = "```json\n";
  const std::size_t from = text.find(fence);
  if (from == std::string::npos) return "";
  const std::size_t begin = from + fence.size();
  return text.substr(begin, text.find("```", begin) - begin);
}

TEST(RobotManual, ItsExampleIsARobot) {
  const std::string text =
      first_json_block(std::filesystem::path(PREHEND_SOURCE_DIR) / "docs/robot-file.md");
  const Robot robot = load_robot(test::write_robot_text(text));
  EXPECT_EQ(robot.name, "vice");
  std::vector<Pose> X_BL;
  link_poses(robot, joint_values(robot, {0.06}), X_BL);
  const Bounds jaw = bounds(transformed(robot.links[1].mesh, X_BL[1]));
  EXPECT_NEAR(jaw.lower.x(), 0.04, 1e-12) << "60 mm from the fixed finger at x = -20 mm";
}

}  // namespace
}  // namespace prehend
