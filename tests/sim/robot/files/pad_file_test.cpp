// Pads of links in robot files.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/robot/files/robot_text.h"
#include "tests/sim/robot/files/robot_files.h"

namespace prehend {
namespace {

using Json = nlohmann::json;
using test::complaint_about;
using test::write_robot_text;

Json with_pad() {
  Json robot = test::small_robot();
  robot["chains"][1]["links"][0]["pad"] = {{"outward", {0, 0, 2}},
                                           {"thickness", 1.5},
                                           {"youngs_modulus", 1e6},
                                           {"poissons_ratio", 0.49}};
  return robot;
}

TEST(PadFile, IsReadWithItsUnits) {
  const Robot robot = load_robot(write_robot_text(with_pad().dump()));
  const Link& tip = robot.links.back();
  ASSERT_TRUE(tip.pad);
  EXPECT_EQ(tip.pad->outward_L, Vector3::UnitZ());
  EXPECT_DOUBLE_EQ(tip.pad->thickness, 1.5e-3);
  EXPECT_DOUBLE_EQ(tip.pad->material.youngs_modulus, 1e6);
  EXPECT_DOUBLE_EQ(tip.pad->material.poissons_ratio, 0.49);
  EXPECT_FALSE(robot.links.front().pad);
  const Robot again = load_robot(write_robot_text(robot_text(robot)));
  EXPECT_TRUE(again.links.back().pad == tip.pad);
}

struct BadPad {
  const char* field;
  const char* value;
  const char* complaint;
};

TEST(PadFile, BadPadsAreRefusedInOneLine) {
  const std::vector<BadPad> all = {
      {"poissons_ratio", "0.5", "poissons_ratio: must be at least 0 and at most 0.4999"},
      {"poissons_ratio", "-0.1", "poissons_ratio: must be at least 0"},
      {"youngs_modulus", "0", "youngs_modulus: must be at least 100"},
      {"youngs_modulus", "-1", "youngs_modulus: must be"},
      {"thickness", "0", "thickness: must be above 0"},
      {"outward", "[0, 0, 0]", "outward: "},
      {"hardness", "50", "hardness: unknown field"}};
  for (const BadPad& bad : all) {
    Json robot = with_pad();
    robot["chains"][1]["links"][0]["pad"][bad.field] = Json::parse(bad.value);
    const std::string complaint = complaint_about(write_robot_text(robot.dump()));
    EXPECT_NE(complaint.find(bad.complaint), std::string::npos) << complaint;
    EXPECT_NE(complaint.find(".pad"), std::string::npos) << complaint;
    EXPECT_EQ(complaint.find('\n'), std::string::npos) << complaint;
  }
}

}  // namespace
}  // namespace prehend
