#include "sim/robot/files/sdf_file.h"

#include <string>

#include <gtest/gtest.h>

#include "tests/sim/robot/files/foreign_files.h"

namespace prehend {
namespace {

constexpr double kSdfRounding = 1e-12;

std::string sdf(const std::string& inside, const std::string& version = "1.9") {
  return "<sdf version=\"" + version + "\"><model name=\"made\">\n" + inside + "</model></sdf>\n";
}

std::string sdf_link(const std::string& name, const std::string& pose) {
  return "<link name=\"" + name + "\">" + pose +
         "<collision name=\"c\"><geometry><box><size>0.02 0.02 0.02</size></box></geometry>"
         "</collision></link>\n";
}

std::string sdf_joint(const std::string& name, const std::string& type, const std::string& parent,
                      const std::string& child, const std::string& inside) {
  return "<joint name=\"" + name + "\" type=\"" + type + "\"><parent>" + parent +
         "</parent><child>" + child + "</child>" + inside + "</joint>\n";
}

Robot sdf_robot(const std::string& text) { return test::read_text(text).robots.at(0).robot; }

std::vector<Vector3> sdf_centers(const Robot& robot, const std::vector<double>& dofs) {
  std::vector<Pose> X_BL;
  link_poses(robot, joint_values(robot, dofs), X_BL);
  std::vector<Vector3> points;
  for (std::size_t l = 0; l < X_BL.size(); ++l) {
    points.push_back(X_BL[l] * bounds(robot.links[l].mesh).center());
  }
  return points;
}

const char* const kSdfTurn =
    "<axis><xyz>0 0 1</xyz><limit><lower>-1</lower><upper>2</upper></limit></axis>";

// At zero all links are where their poses say, whatever those are relative to; joints turn about
// their own points.
TEST(SdfFile, PosesAreRelativeToAnyFrame) {
  const Robot robot = sdf_robot(sdf(
      "<frame name=\"f\" attached_to=\"base\"><pose>0 0 0.1 0 0 1.5707963267948966</pose></frame>" +
      sdf_link("base", "<pose>0 0 1 0 0 0</pose>") +
      sdf_link("a", "<pose relative_to=\"f\">0.2 0 0 0 0 0</pose>") +
      sdf_link("b", "<pose relative_to=\"ja\">0 0 0.3 0 0 0</pose>") +
      sdf_joint("ja", "revolute", "base", "a",
                std::string("<pose>-0.1 0 0 0 0 0</pose>") + kSdfTurn) +
      sdf_joint("jb", "revolute", "a", "b", kSdfTurn)));
  ASSERT_EQ(robot.dofs.size(), 2U);
  const std::vector<Vector3> rest = sdf_centers(robot, {0.0, 0.0});
  EXPECT_LT((rest[1] - Vector3(0.0, 0.2, 0.1)).norm(), kSdfRounding);
  EXPECT_LT((rest[2] - Vector3(0.0, 0.1, 0.4)).norm(), kSdfRounding);
  // ja is at (0, 0.1, 0.1) of the base: a quarter turn swings a from +y to -x of it.
  const std::vector<Vector3> turned = sdf_centers(robot, {1.5707963267948966, 0.0});
  EXPECT_LT((turned[1] - Vector3(-0.1, 0.1, 0.1)).norm(), kSdfRounding);
  EXPECT_EQ(robot.dofs[0].upper, 2.0);
}

TEST(SdfFile, AxesAreThoseOfTheirFrames) {
  const auto axis = [](const std::string& axis_text, const std::string& version) {
    const Robot robot = sdf_robot(
        sdf(sdf_link("base", "") + sdf_link("a", "<pose>0 0 0.1 0 1.5707963267948966 0</pose>") +
                sdf_joint("j", "prismatic", "base", "a", "<axis>" + axis_text + "</axis>"),
            version));
    EXPECT_EQ(robot.dofs[0].upper, 1.0);  // without a limit
    return Vector3(robot.joints[0].X_PJ.linear() * robot.joints[0].axis);
  };
  const Vector3 x = Vector3::UnitX();
  const Vector3 z = Vector3::UnitZ();
  EXPECT_LT((axis("<xyz>0 0 1</xyz>", "1.10") - x).norm(), kSdfRounding);
  EXPECT_LT((axis("<xyz expressed_in=\"__model__\">0 0 1</xyz>", "1.7") - z).norm(), kSdfRounding);
  EXPECT_LT((axis("<xyz>0 0 1</xyz>", "1.4") - z).norm(), kSdfRounding);
  EXPECT_LT(
      (axis("<xyz>0 0 1</xyz><use_parent_model_frame>true</use_parent_model_frame>", "1.6") - z)
          .norm(),
      kSdfRounding);
}

TEST(SdfFile, MimicsCountFromTheirReference) {
  const std::string mimic =
      "<axis><xyz>0 0 1</xyz><limit><lower>-1</lower><upper>2</upper></limit><mimic joint=\"ja\">"
      "<multiplier>0.5</multiplier><offset>0.1</offset><reference>0.4</reference></mimic></axis>";
  const Robot robot = sdf_robot(sdf(sdf_link("base", "") + sdf_link("a", "") + sdf_link("b", "") +
                                        sdf_joint("ja", "revolute", "base", "a", kSdfTurn) +
                                        sdf_joint("jb", "revolute", "base", "b", mimic) +
                                        sdf_joint("hold", "fixed", "world", "base", ""),
                                    "1.11"));
  ASSERT_EQ(robot.dofs.size(), 1U);
  EXPECT_EQ(robot.joints[1].ratio, 0.5);
  EXPECT_NEAR(robot.joints[1].offset, -0.1, kSdfRounding);
}

struct BadSdf {
  const char* text;
  const char* complaint;
};

TEST(SdfFile, MistakesAreNamed) {
  const std::vector<BadSdf> all = {
      {"<include><uri>model://hand</uri></include>",
       "line 2, <include>: not found in or above the folder of the file, nor in ROS_PACKAGE_PATH; "
       "say where its package is with --package hand=FOLDER (model://hand/model.sdf)"},
      {"<include><uri>https://fuel/hand</uri></include>",
       "line 2, <include>: only local models can be read: save it, and name its folder "
       "(https://fuel/hand)"},
      {"<model name=\"m\"/>", "line 2, <model>: must have a link (m)"},
      {"<link name=\"a\"/><link name=\"a\"/>", "line 2, <link>: name used twice (a)"},
      {"<link name=\"a\"><pose relative_to=\"b\">0 0 0 0 0 0</pose></link>",
       "line 2, <link>: no frame of this name (b)"},
      {"<link name=\"a\"><pose>0 0</pose></link>", "line 2, <pose>: must have 6 numbers (0 0)"},
      {"<frame name=\"a\"><pose relative_to=\"b\"/></frame><frame name=\"b\"><pose "
       "relative_to=\"a\"/></frame><link name=\"l\"><pose relative_to=\"a\">0 0 0 0 0 "
       "0</pose></link>",
       "line 2, <frame>: frames must not be relative to each other in a circle, or more than 200 "
       "in a row"},
      {"<link name=\"a\"/><joint name=\"j\" "
       "type=\"fixed\"><parent>a</parent><child>c</child></joint>",
       "line 2, <child>: no link of this name (c)"},
      {"<link name=\"a\"/><link name=\"b\"/>\n<joint name=\"j\" "
       "type=\"ball\"><parent>a</parent><child>b</child></joint>",
       "line 3, <joint>: unknown joint type, known are revolute, continuous, prismatic and fixed "
       "(ball)"},
  };
  for (const BadSdf& bad : all) {
    EXPECT_EQ(test::foreign_complaint(sdf(bad.text)), bad.complaint);
  }
  EXPECT_EQ(test::foreign_complaint("<sdf version=\"1.7\"/>"),
            "line 1, <sdf>: there is no <model> inside");
}

}  // namespace
}  // namespace prehend
