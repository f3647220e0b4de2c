#include "sim/robot/files/hand_split.h"

#include "sim/base/index.h"
#include "sim/robot/files/robot_file.h"
#include "tests/sim/robot/files/foreign_files.h"

namespace prehend {
namespace {

using test::box_link;
using test::has_note;
using test::kLimit;
using test::read_text;
using test::test_folder;
using test::urdf;
using test::urdf_joint;
using test::write_text;

// An arm of so many joints, a flange and a palm fixed to its end, and two fingers on the palm.
std::string arm_with_gripper(int joints) {
  std::string text = box_link("base");
  std::string last = "base";
  for (int k = 1; k <= joints; ++k) {
    const std::string name = "arm" + std::to_string(k);
    text += box_link(name);
    text += urdf_joint("j" + std::to_string(k), "revolute", last, name,
                       std::string("<origin xyz=\"0 0 0.3\"/><axis xyz=\"0 1 0\"/>") + kLimit);
    last = name;
  }
  text += "<link name=\"flange\"/>" + box_link("palm") + box_link("left") + box_link("right");
  text += urdf_joint("to_flange", "fixed", last, "flange", "<origin xyz=\"0 0 0.1\"/>");
  text += urdf_joint("to_palm", "fixed", "flange", "palm",
                     "<origin xyz=\"0 0.01 0\" rpy=\"0 0 0.7\"/>");
  const std::string slide = "<limit lower=\"0\" upper=\"0.05\"/>";
  text += urdf_joint("left", "prismatic", "palm", "left", "<axis xyz=\"0 1 0\"/>" + slide);
  text += urdf_joint("right", "prismatic", "palm", "right", "<axis xyz=\"0 -1 0\"/>" + slide);
  return urdf(text);
}

TEST(HandSplit, FingersOnAnArmAreAHand) {
  const Platform platform = read_text(arm_with_gripper(6));
  ASSERT_EQ(platform.robots.size(), 2U);
  const MountedRobot& arm = platform.robots[0];
  const MountedRobot& hand = platform.robots[1];
  EXPECT_EQ(arm.name, "arm");
  EXPECT_EQ(hand.name, "hand");
  EXPECT_EQ(hand.parent, 0);
  EXPECT_EQ(arm.robot.joints.size(), 6U);
  EXPECT_EQ(hand.robot.joints.size(), 2U);
  EXPECT_EQ(hand.robot.links[0].name, "palm");
  EXPECT_LT((hand.X_MR.translation() - Vector3(0.0, 0.01, 0.1)).norm(), 1e-12);
  EXPECT_TRUE(has_note(hand.robot, "the hand begins with link palm"));
  EXPECT_EQ(test::read_text(arm_with_gripper(2)).robots.size(), 1U);
}

// All links stand where those of the undivided robot stand.
TEST(HandSplit, NothingMovesByIt) {
  const std::filesystem::path file = write_text(test_folder() / "made.urdf", arm_with_gripper(4));
  const AssembledPlatform parts = assemble(*read_foreign_robot(file));
  write_text(test_folder() / "made.urdf", arm_with_gripper(4));
  write_text(file.parent_path() / "made.prehend.json", R"({"hand_root": null})");
  const Robot whole = read_foreign_robot(file)->robots.at(0).robot;
  ASSERT_EQ(whole.links.size(), parts.robot.links.size());
  const std::vector<double> dofs = {0.3, -0.4, 0.5, 0.9, 0.01, 0.02};
  std::vector<Pose> X_whole;
  std::vector<Pose> X_parts;
  link_poses(whole, joint_values(whole, dofs), X_whole);
  link_poses(parts.robot, joint_values(parts.robot, dofs), X_parts);
  for (std::size_t l = 0; l < whole.links.size(); ++l) {
    for (std::size_t v = 0; v < whole.links[l].mesh.vertices.size(); ++v) {
      const Vector3 p = X_whole[l] * whole.links[l].mesh.vertices[v];
      EXPECT_LT((p - X_parts[l] * parts.robot.links[l].mesh.vertices[v]).norm(), 1e-12);
    }
  }
}

TEST(HandSplit, OneRobotIsTheHandAlone) {
  const std::filesystem::path file = write_text(test_folder() / "made.urdf", arm_with_gripper(6));
  const Robot robot = find_robot(file.string());
  EXPECT_EQ(robot.links[0].name, "palm");
  EXPECT_TRUE(has_note(robot, "without its arm"));
}

TEST(HandSplit, CouplingsAcrossKeepItWhole) {
  std::string text = arm_with_gripper(4);
  const std::string plain = "<axis xyz=\"0 1 0\"/><limit lower=\"0\" upper=\"0.05\"/></joint>";
  const std::size_t at = text.find(plain);
  ASSERT_NE(at, std::string::npos);
  text = text.replace(text.find("j4\" type=\"revolute"), 18, "j4\" type=\"prismatic");
  text.insert(text.find("</joint>", text.find("name=\"left\" type")), "<mimic joint=\"j4\"/>");
  EXPECT_EQ(read_text(text).robots.size(), 1U);
}

const char* const kSrdf = R"(<robot name="made">
<group name="arm"><chain base_link="base" tip_link="flange"/></group>
<group name="fingers"><link name="palm"/><joint name="left"/><link name="right"/></group>
<group name="gripper"><group name="fingers"/></group>
<group_state name="home" group="arm"><joint name="j1" value="0.5"/></group_state>
<group_state name="open" group="gripper"><joint name="left" value="0.04"/></group_state>
<group_state name="broken" group="arm"><joint name="j1" value="0.9"/></group_state>
<end_effector name="hand" parent_link="flange" group="gripper"/>
<disable_collisions link1="base" link2="arm2" reason="Never"/>
<disable_collisions link1="arm1" link2="palm"/>
<disable_collisions link1="left" link2="right"/>
<disable_collisions link1="left" link2="camera"/>
</robot>)";

TEST(Srdf, NamesTheHandAndWhatNeverCollides) {
  const std::filesystem::path file = write_text(test_folder() / "made.urdf", arm_with_gripper(2));
  write_text(file.parent_path() / "made.srdf", kSrdf);
  const Platform platform = *read_foreign_robot(file);
  ASSERT_EQ(platform.robots.size(), 2U);
  const Robot& arm = platform.robots[0].robot;
  const Robot& hand = platform.robots[1].robot;
  EXPECT_EQ(arm.exempt_pairs, (std::vector<std::pair<int, int>>{{0, 2}}));
  EXPECT_EQ(hand.exempt_pairs, (std::vector<std::pair<int, int>>{{1, 2}}));
  EXPECT_EQ(arm.dofs[0].initial, 0.5);
  EXPECT_EQ(hand.dofs[0].initial, 0.04);
  EXPECT_TRUE(has_note(hand, "camera"));
  // base, arm1, arm2, palm, left, right.
  const Robot whole = assemble(platform).robot;
  EXPECT_EQ(whole.exempt_pairs, (std::vector<std::pair<int, int>>{{0, 2}, {4, 5}, {1, 3}}));
}

TEST(Srdf, MistakesAreNamed) {
  const std::filesystem::path file = write_text(test_folder() / "made.urdf", arm_with_gripper(2));
  const std::filesystem::path srdf = file.parent_path() / "made.srdf";
  const auto complaint = [&](const std::string& inside) {
    write_text(srdf, "<robot name=\"made\">\n" + inside + "</robot>");
    try {
      (void)read_foreign_robot(file);
    } catch (const InputError& error) {
      const std::string text = error.what();
      return text.substr(std::min(text.size(), srdf.string().size() + 2));
    }
    return std::string();
  };
  EXPECT_EQ(complaint("<end_effector name=\"e\" group=\"g\"/>"),
            "line 2, <end_effector>: no group of this name (g)");
  EXPECT_EQ(complaint("<group name=\"g\"><chain base_link=\"left\" tip_link=\"arm1\"/></group>"
                      "<end_effector name=\"e\" group=\"g\"/>"),
            "line 2, <chain>: does not lead from its base to its tip (arm1)");
  // Groups that contain each other are gathered once.
  EXPECT_EQ(complaint("<group name=\"g\"><group name=\"h\"/></group><group name=\"h\"><group "
                      "name=\"g\"/><link name=\"palm\"/></group><end_effector name=\"e\" "
                      "group=\"g\"/>"),
            "");
}

TEST(Sidecar, SaysWhatTheFormatCannot) {
  const std::filesystem::path file = write_text(test_folder() / "made.urdf", arm_with_gripper(6));
  write_text(file.parent_path() / "made.prehend.json", R"({
    "units": {"length": "mm"},
    "materials": {"*": "metal", "left": "rubber"},
    "exempt_collisions": [["left", "right"]],
    "dofs": [{"name": "left", "closing_velocity": -50, "initial": 20}, {"name": "j1",
              "acceleration": 2}],
    "hand": {"approach": [0, 0, 1], "closing": [0, 1, 0], "origin": [0, 0, 10],
             "preshapes": [{"name": "open", "dofs": {"left": 50}, "width": [0, 90], "depth": 5}]}
  })");
  const Platform platform = *read_foreign_robot(file);
  const Robot& hand = platform.robots.at(1).robot;
  EXPECT_EQ(platform.robots[0].robot.links[0].material, "metal");
  EXPECT_EQ(platform.robots[0].robot.dofs[0].max_acceleration, 2.0);
  EXPECT_EQ(hand.links[1].material, "rubber");
  EXPECT_NEAR(hand.dofs[0].closing_velocity, -0.05, 1e-15);
  EXPECT_NEAR(hand.dofs[0].initial, 0.02, 1e-15);
  EXPECT_EQ(hand.exempt_pairs.size(), 1U);
  ASSERT_TRUE(hand.hand);
  EXPECT_NEAR(hand.hand->preshapes.at(0).dofs.at(0), 0.05, 1e-15);
  EXPECT_FALSE(has_note(hand, "plastic"));
}

TEST(Sidecar, MistakesAreNamed) {
  const std::filesystem::path file = write_text(test_folder() / "made.urdf", arm_with_gripper(6));
  const std::filesystem::path sidecar = file.parent_path() / "made.prehend.json";
  const auto complaint = [&](const std::string& text) {
    write_text(sidecar, text);
    try {
      (void)read_foreign_robot(file);
    } catch (const InputError& error) {
      const std::string message = error.what();
      return message.substr(std::min(message.size(), sidecar.string().size() + 2));
    }
    return std::string();
  };
  EXPECT_EQ(complaint(R"({"material": {}})").substr(0, 8), "material");
  EXPECT_EQ(complaint(R"({"materials": {"lft": "rubber"}})"),
            "materials.lft: no link is called lft (\"rubber\")");
  EXPECT_EQ(complaint(R"({"hand_root": "base"})"),
            "hand_root: no hand can be parted from the rest here (base)");
  EXPECT_EQ(complaint(R"({"hand_root": "plam"})"), "hand_root: no link of this name (plam)");
  EXPECT_EQ(complaint(R"({"dofs": [{"name": "thumb"}]})"),
            "dofs[0].name: no degree of freedom of this name (\"thumb\")");
}

}  // namespace
}  // namespace prehend
