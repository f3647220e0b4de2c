#include "sim/robot/files/sdf_parts.h"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "tests/sim/robot/files/foreign_files.h"

namespace prehend {
namespace {

constexpr double kPartRounding = 1e-9;

std::string part_link(const std::string& name, const std::string& pose = "") {
  return "<link name=\"" + name + "\">" + (pose.empty() ? "" : "<pose>" + pose + "</pose>") +
         "<collision name=\"c\"><geometry><box><size>0.02 0.02 0.02</size></box></geometry>"
         "</collision></link>\n";
}

std::string part_joint(const std::string& name, const std::string& parent, const std::string& child,
                       const std::string& type = "revolute") {
  return "<joint name=\"" + name + "\" type=\"" + type + "\"><parent>" + parent +
         "</parent><child>" + child +
         "</child><axis><xyz>0 0 1</xyz><limit><lower>-0.5</lower><upper>0.5</upper></limit>"
         "</axis></joint>\n";
}

std::string part_model(const std::string& name, const std::string& inside) {
  return "<model name=\"" + name + "\">\n" + inside + "</model>\n";
}

std::string part_sdf(const std::string& inside) {
  return "<sdf version=\"1.9\">" + inside + "</sdf>\n";
}

// A hand of one finger.
std::string part_hand(const std::string& name) {
  return part_model(name, part_link("palm") + part_link("finger", "0.05 0 0.1 0 0 1") +
                              part_joint("bend", "palm", "finger"));
}

// Where all joints are at 0.
Vector3 part_center(const Robot& robot, const std::string& link) {
  std::vector<Pose> X_BL;
  link_poses(robot, joint_values(robot, std::vector<double>(robot.dofs.size(), 0.0)), X_BL);
  for (std::size_t l = 0; l < X_BL.size(); ++l) {
    if (robot.links[l].name == link) return X_BL[l] * bounds(robot.links[l].mesh).center();
  }
  ADD_FAILURE() << "no link " << link;
  return Vector3::Zero();
}

Robot part_robot(const std::filesystem::path& file, const ForeignRobotOptions& options = {}) {
  return robot_alone(read_foreign_robot(file, options).value());
}

TEST(SdfParts, ModelsInsideAModelHaveNamesOfTheirOwn) {
  const std::string hand = "<model name=\"h\"><pose>0 0.3 0 0 0 1.5707963267948966</pose>" +
                           part_link("palm") + part_link("finger", "0.1 0 0 0 0 0") +
                           part_joint("bend", "palm", "finger") + "</model>";
  const Robot robot = part_robot(test::write_text(
      test::test_folder() / "made.sdf",
      part_sdf(part_model("both",
                          part_link("base") + hand + part_joint("mount", "base", "h", "fixed")))));
  ASSERT_EQ(robot.dofs.size(), 1U);
  EXPECT_EQ(robot.dofs[0].name, "h::bend");
  EXPECT_LT((part_center(robot, "h::finger") - Vector3(0.0, 0.4, 0.0)).norm(), kPartRounding);
}

TEST(SdfParts, IncludedModelsAreFoundByTheirFolder) {
  const std::filesystem::path folder = test::test_folder();
  test::write_text(folder / "models/hand/model.config",
                   "<model><sdf version=\"1.5\">old.sdf</sdf><sdf version=\"1.9\">hand.sdf</sdf>"
                   "</model>");
  test::write_text(folder / "models/hand/meshes/cube.obj", test::kUnitCubeObj);
  const std::string finger =
      "<link name=\"finger\"><visual name=\"v\"><geometry><mesh><uri>meshes/cube.obj</uri></mesh>"
      "</geometry></visual></link>";
  test::write_text(folder / "models/hand/hand.sdf",
                   part_sdf(part_model(
                       "hand", part_link("palm") + finger + part_joint("bend", "palm", "finger"))));
  const std::string arm = part_sdf(part_model(
      "both", part_link("base") +
                  "<include><uri>model://hand</uri><name>left</name><pose>0 0 2 0 0 0</pose>"
                  "</include>" +
                  part_joint("turn", "base", "left::palm")));
  const Robot robot = part_robot(test::write_text(folder / "models/arm/arm.sdf", arm));
  ASSERT_EQ(robot.links.size(), 3U);
  EXPECT_LT((part_center(robot, "left::finger") - Vector3(0.5, 0.5, 2.5)).norm(), 1e-6);
  const Robot elsewhere = part_robot(test::write_text(folder / "far/arm.sdf", arm),
                                     {.packages = {{"hand", folder / "models/hand"}}});
  EXPECT_EQ(elsewhere.dofs.size(), 2U);
}

TEST(SdfParts, TheRobotOfAWorldIsTheModelThatMoves) {
  const std::string ground =
      "<include><uri>model://sun</uri></include>" + part_model("table", part_link("top"));
  const Robot robot = part_robot(
      test::write_text(test::test_folder() / "made.world",
                       part_sdf("<world name=\"w\">" + ground + part_hand("hand") + "</world>")));
  EXPECT_EQ(robot.name, "hand");
  EXPECT_LT((part_center(robot, "finger") - Vector3(0.05, 0.0, 0.1)).norm(), kPartRounding);
  EXPECT_EQ(test::foreign_complaint(part_sdf("<world name=\"w\">" + ground + part_hand("hand") +
                                             part_hand("other") + "</world>")),
            "line 9, <model>: there are several models; give a file of one (hand, other)");
}

// A parallelogram of four bars whose coupler hangs on both cranks.
TEST(SdfParts, ALinkWithTwoParentsClosesALoop) {
  const std::string close =
      "<joint name=\"close\" type=\"revolute\"><pose>0.1 0 0 0 0 0</pose><parent>other</parent>"
      "<child>coupler</child><axis><xyz>0 0 1</xyz></axis></joint>";
  const Robot robot = part_robot(test::write_text(
      test::test_folder() / "made.sdf",
      part_sdf(part_model(
          "bars", part_link("base") + part_link("crank") + part_link("other", "0.1 0 0 0 0 0") +
                      part_link("coupler", "0 0.05 0 0 0 0") +
                      part_joint("drive", "base", "crank") + part_joint("follow", "base", "other") +
                      part_joint("elbow", "crank", "coupler") + close))));
  ASSERT_EQ(robot.dofs.size(), 1U);
  ASSERT_EQ(robot.joints.size(), 3U);
  for (const Joint& joint : robot.joints) {
    EXPECT_NEAR(joint.ratio, joint.name == "elbow" ? -1.0 : 1.0, 1e-3) << joint.name;
  }
}

TEST(SdfParts, ModelsThatIncludeThemselvesAreRefused) {
  const std::filesystem::path file = test::test_folder() / "made.sdf";
  test::write_text(file, part_sdf(part_model("m", "<include><uri>made.sdf</uri></include>")));
  try {
    (void)read_foreign_robot(file);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("models must be inside each other at most 20 deep"),
              std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace prehend
