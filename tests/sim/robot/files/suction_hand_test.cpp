// Hands with suction cups in robot files.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/robot/files/robot_text.h"
#include "tests/sim/robot/files/robot_files.h"
#include "tests/sim/robot/files/same_robot.h"

namespace prehend {
namespace {

using Json = nlohmann::json;
using test::complaint_about;
using test::write_robot_text;

Json small_cup() {
  return Json::parse(R"({
    "name": "small", "units": {"length": "mm"},
    "base": {"name": "holder", "material": "metal",
             "geometry": [{"shape": "box", "size": [10, 10, 10]}]},
    "links": [{"name": "cup", "material": "rubber",
               "geometry": [{"shape": "box", "size": [20, 20, 10],
                             "pose": [{"translate": [0, 0, 10]}]}]}],
    "chains": [], "dofs": [],
    "hand": {"approach": [0, 0, 1], "origin": [0, 0, 15],
             "cups": [{"link": "cup", "position": [1, 2, 15], "radius": 10,
                       "lip_stiffness": 9000, "travel": 4, "pull": 20}]}
  })");
}

TEST(SuctionHand, IsReadWithItsUnits) {
  const Robot robot = load_robot(write_robot_text(small_cup().dump()));
  ASSERT_TRUE(robot.hand);
  ASSERT_EQ(robot.hand->cups.size(), 1U);
  const SuctionCup& cup = robot.hand->cups[0];
  EXPECT_EQ(robot.links[static_cast<std::size_t>(cup.link)].name, "cup");
  EXPECT_LT((cup.position - Vector3(0.001, 0.002, 0.015)).norm(), 1e-15);
  EXPECT_EQ(cup.axis, Vector3::UnitZ());
  EXPECT_DOUBLE_EQ(cup.radius, 0.01);
  EXPECT_DOUBLE_EQ(cup.lip_stiffness, 9000.0);
  EXPECT_DOUBLE_EQ(cup.travel, 0.004);
  EXPECT_DOUBLE_EQ(cup.pull, 20.0);
  EXPECT_DOUBLE_EQ(cup.strain, 0.1);
  EXPECT_EQ(robot.hand->preshapes.size(), 1U);
  EXPECT_TRUE(robot.dofs.empty());
}

TEST(SuctionHand, IsWrittenAndReadAgain) {
  for (const char* name : {"suction_cup_30", "suction_array_4"}) {
    const Robot robot = find_robot(name);
    const Robot again = load_robot(write_robot_text(robot_text(robot)));
    test::expect_same_hand(robot, again);
    ASSERT_EQ(again.hand->cups.size(), robot.hand->cups.size());
    for (std::size_t c = 0; c < robot.hand->cups.size(); ++c) {
      const SuctionCup& a = robot.hand->cups[c];
      const SuctionCup& b = again.hand->cups[c];
      EXPECT_EQ(a.link, b.link);
      EXPECT_EQ(a.position, b.position);
      EXPECT_EQ(a.radius, b.radius);
      EXPECT_EQ(a.lip_stiffness, b.lip_stiffness);
      EXPECT_EQ(a.travel, b.travel);
      EXPECT_EQ(a.pull, b.pull);
      EXPECT_EQ(a.strain, b.strain);
    }
  }
}

// The area of the lip times the pressure difference that its README names.
TEST(SuctionHand, OfTheLibraryPullsWhatItsAreaDoes) {
  const Robot robot = find_robot("suction_array_4");
  for (const SuctionCup& cup : robot.hand->cups) {
    EXPECT_NEAR(cup.pull, 3.14159265 * cup.radius * cup.radius * 60e3, 0.5);
  }
}

struct BadCup {
  const char* field;  // of the cup
  const char* value;
  std::string complaint;
};

TEST(SuctionHand, BadCupsAreRefusedInOneLine) {
  const std::string at = "hand.cups[0].";
  const std::vector<BadCup> all = {
      {"radius", "-10", at + "radius: must be above 0"},
      {"radius", "0", at + "radius: must be above 0"},
      {"lip_stiffness", "0", at + "lip_stiffness: must be above 0"},
      {"lip_stiffness", "-1", at + "lip_stiffness: must be above 0"},
      {"travel", "0", at + "travel: must be above 0"},
      {"pull", "-5", at + "pull: must be above 0"},
      {"strain", "0", at + "strain: must be above 0"},
      {"strain", "1.5", at + "strain: must be"},
      {"axis", "[0, 0, -1]", at + "axis: must be within 60 degrees of the approach axis"},
      {"axis", "[0, 0, 0]", at + "axis: "},
      {"link", R"("cop")", at + "link: no link of this name"},
      {"position", "[0, 0]", at + "position: "},
      {"width", "3", at + "width: unknown field"}};
  for (const BadCup& bad : all) {
    Json robot = small_cup();
    robot["hand"]["cups"][0][bad.field] = Json::parse(bad.value);
    const std::string complaint = complaint_about(write_robot_text(robot.dump()));
    EXPECT_NE(complaint.find(bad.complaint), std::string::npos) << complaint;
    EXPECT_EQ(complaint.find('\n'), std::string::npos) << complaint;
  }
  Json none = small_cup();
  none["hand"]["cups"] = Json::array();
  EXPECT_NE(
      complaint_about(write_robot_text(none.dump())).find("hand.cups: needs at least one cup"),
      std::string::npos);
  Json closing = small_cup();
  closing["hand"]["closing"] = {1, 0, 0};
  EXPECT_NE(complaint_about(write_robot_text(closing.dump()))
                .find("hand.closing: not of a hand with cups"),
            std::string::npos);
}

}  // namespace
}  // namespace prehend
