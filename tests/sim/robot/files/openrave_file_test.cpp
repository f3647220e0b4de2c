#include "sim/robot/files/openrave_file.h"

#include <algorithm>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/base/index.h"
#include "tests/sim/robot/files/foreign_files.h"
#include "tests/support/refusal_of.h"

namespace prehend {
namespace {

constexpr double kTyped = 1e-9;

std::string openrave_body(
    const std::string& name, const std::string& inside,
    const std::string& shape = "<Geom type=\"box\"><Extents>0.01 0.01 0.01</Extents></Geom>") {
  return "<Body name=\"" + name + "\" type=\"dynamic\">" + inside + shape + "</Body>\n";
}

std::string openrave_joint(const std::string& attributes, const std::string& first,
                           const std::string& second, const std::string& inside) {
  return "<Joint " + attributes + "><Body>" + first + "</Body><Body>" + second + "</Body>" +
         inside + "</Joint>\n";
}

std::string kinbody(const std::string& inside) {
  return "<KinBody name=\"made\">\n" + inside + "</KinBody>\n";
}

Robot openrave_robot(const std::string& text) { return test::read_text(text).robots.at(0).robot; }

Vector3 openrave_center(const Robot& robot, const std::vector<double>& dofs, std::size_t link) {
  std::vector<Pose> X_BL;
  link_poses(robot, joint_values(robot, dofs), X_BL);
  return X_BL[link] * bounds(robot.links[link].mesh).center();
}

// The anchor is 0.1 m up the base, given in the frame of the finger, which stands 0.3 m up and
// looks along y: a quarter turn about x swings its middle from +z to -y.
TEST(OpenraveFile, AnchorsAndAxesAreInTheFrameThatTheyName) {
  const Robot robot = openrave_robot(kinbody(
      openrave_body("base", "") +
      openrave_body("finger",
                    "<offsetfrom>base</offsetfrom><Translation>0 0 0.3</Translation>"
                    "<RotationAxis>0 0 1 90</RotationAxis>") +
      openrave_joint("name=\"j\" type=\"hinge\"", "base", "finger",
                     "<offsetfrom>finger</offsetfrom><anchor>0 0 -0.2</anchor><axis>0 -1 0</axis>"
                     "<limitsdeg>-90 90</limitsdeg><maxvel>2</maxvel><maxtorque>3</maxtorque>")));
  ASSERT_EQ(robot.dofs.size(), 1U);
  EXPECT_NEAR(robot.dofs[0].upper, 0.5 * std::numbers::pi, kTyped);
  EXPECT_EQ(robot.dofs[0].max_velocity, 2.0);
  EXPECT_EQ(robot.joints[0].max_effort, 3.0);
  EXPECT_LT((openrave_center(robot, {0.0}, 1) - Vector3(0.0, 0.0, 0.3)).norm(), kTyped);
  const Vector3 turned = openrave_center(robot, {0.5 * std::numbers::pi}, 1);
  EXPECT_LT((turned - Vector3(0.0, -0.2, 0.1)).norm(), kTyped) << turned.transpose();
}

// The base is what stands first in the file, also where a joint names the other body first.
TEST(OpenraveFile, JointsAreTurnedRoundThatNameTheirChildFirst) {
  const std::string bodies =
      openrave_body("base", "") + openrave_body("slide", "<Translation>0 0 0.1</Translation>");
  for (const bool reversed : {false, true}) {
    const Robot robot = openrave_robot(
        kinbody(bodies + openrave_joint("name=\"j\" type=\"slider\"", reversed ? "slide" : "base",
                                        reversed ? "base" : "slide",
                                        "<axis>0 0 1</axis><limits>0 0.05</limits>")));
    const double way = reversed ? -0.04 : 0.04;
    EXPECT_NEAR(openrave_center(robot, {0.04}, 1).z(), 0.1 + way, kTyped);
  }
}

TEST(OpenraveFile, CylindersStandAlongY) {
  const Robot robot = openrave_robot(kinbody(
      openrave_body("base", "",
                    "<Geom type=\"cylinder\"><Translation>0 0 1</Translation><radius>0.1</radius>"
                    "<height>0.6</height></Geom>") +
      openrave_body("ball", "", "<Geom type=\"sphere\"><radius>0.1</radius></Geom>") +
      openrave_joint("name=\"j\" type=\"hinge\"", "base", "ball", "<axis>1 0 0</axis>")));
  const Vector3 size = bounds(robot.links[0].mesh).size();
  EXPECT_NEAR(size.y(), 0.6, kTyped);
  EXPECT_NEAR(size.z(), 0.2, 2e-3);
  EXPECT_NEAR(bounds(robot.links[0].mesh).center().z(), 1.0, kTyped);
  EXPECT_NEAR(robot.dofs[0].lower, -std::numbers::pi, kTyped);
}

TEST(OpenraveFile, MimicsAreLinearExpressions) {
  const std::string bodies =
      openrave_body("base", "") + openrave_body("a", "") + openrave_body("b", "");
  const std::string limits = "<axis>0 0 1</axis><limits>-1 1</limits>";
  struct Case {
    const char* attribute;
    double ratio;
    double offset;
  };
  for (const Case& c : std::vector<Case>{{"mimic_pos=\"ja\"", 1.0, 0.0},
                                         {"mimic_pos=\"-ja\"", -1.0, 0.0},
                                         {"mimic_pos=\"0.1 + 0.5*ja\"", 0.5, 0.1},
                                         {"mimic_pos=\"ja*-0.25-1e-2\"", -0.25, -0.01},
                                         {"mimic=\"ja 0.5 0.2\"", 0.5, 0.2},
                                         {"mimic=\"ja\"", 1.0, 0.0}}) {
    const Robot robot = openrave_robot(kinbody(
        bodies + openrave_joint("name=\"ja\" type=\"hinge\"", "base", "a", limits) +
        openrave_joint(std::string("name=\"jb\" type=\"hinge\" enable=\"false\" ") + c.attribute,
                       "base", "b", "<axis>0 0 1</axis><limits>-2 2</limits>")));
    ASSERT_EQ(robot.dofs.size(), 1U) << c.attribute;
    EXPECT_NEAR(robot.joints[1].ratio, c.ratio, kTyped) << c.attribute;
    EXPECT_NEAR(robot.joints[1].offset, c.offset, kTyped) << c.attribute;
  }
}

// A robot names the file of its bodies, which are found beside it; names get a prefix, and a
// manipulator becomes a frame.
TEST(OpenraveFile, FilesThatNameFiles) {
  const std::filesystem::path folder = test::test_folder();
  test::write_text(folder / "models/cube.obj", test::kUnitCubeObj);
  test::write_text(folder / "bodies/hand.kinbody.xml",
                   "<kinbody modelsdir=\"../models\">" +
                       openrave_body("base", "",
                                     "<geom type=\"trimesh\"><data>cube.obj 0.1</data></geom>"
                                     "<mass type=\"custom\"><total>2</total><com>0 0 0.05</com>"
                                     "<inertia>1 0 0 0 1 0 0 0 1</inertia></mass>") +
                       openrave_body("jaw", "<translation>0 0 0.2</translation>") +
                       openrave_joint("name=\"j\" type=\"slider\"", "base", "jaw",
                                      "<axis>1 0 0</axis><limits>0 0.1</limits>") +
                       "</kinbody>");
  const std::filesystem::path file = test::write_text(
      folder / "hand.robot.xml",
      "<Robot name=\"made\"><KinBody file=\"bodies/hand.kinbody.xml\" prefix=\"left_\"/>"
      "<Manipulator name=\"arm\"><base>left_base</base><effector>left_jaw</effector>"
      "<Translation>0 0 0.03</Translation></Manipulator></Robot>");
  const Robot robot = read_foreign_robot(file)->robots.at(0).robot;
  EXPECT_EQ(robot.name, "made");
  ASSERT_EQ(robot.links.size(), 2U);
  EXPECT_EQ(robot.links[1].name, "left_jaw");
  EXPECT_NEAR(bounds(robot.links[0].mesh).size().x(), 0.1, kTyped);
  EXPECT_EQ(robot.links[0].inertial.mass, 2.0);
  const auto frame = std::find_if(robot.frames.begin(), robot.frames.end(),
                                  [](const RobotFrame& f) { return f.name == "arm_tcp"; });
  ASSERT_NE(frame, robot.frames.end());
  EXPECT_EQ(frame->role, FrameRole::tool);
  EXPECT_LT((frame->X_AF.translation() - Vector3(0.0, 0.0, 0.03)).norm(), kTyped);
}

TEST(OpenraveFile, WhatCannotBeReadNamesItsPlace) {
  const std::string two = openrave_body("base", "") + openrave_body("a", "");
  const std::string joint = openrave_joint("name=\"j\"", "base", "a", "<axis>0 0 1</axis>");
  struct Case {
    std::string text;
    std::string message;
  };
  for (const Case& c : std::vector<Case>{
           {kinbody(two + openrave_joint("name=\"j\" type=\"spherical\"", "base", "a", "")),
            "joints known are hinge and slider (spherical)"},
           {kinbody(two + openrave_joint("name=\"j\"", "base", "c", "")),
            "<Body>: no <Body> of this name before it (c)"},
           {kinbody(two + joint + openrave_joint("name=\"k\"", "a", "base", "<axis>0 0 1</axis>")),
            "<Joint>: closes a loop of bodies: only trees can be read"},
           {kinbody(two + openrave_joint("name=\"j\" mimic_pos=\"k*k\"", "base", "a", "")),
            "mimic_pos"},
           {kinbody(openrave_body("base", "", "<Geom type=\"cone\"/>")),
            "shapes known are box, sphere, cylinder and trimesh (cone)"},
           {kinbody(openrave_body("base", "", "<Geom type=\"box\"/>")),
            "<Geom>: element <extents> is missing"},
           {"<Environment><Robot name=\"a\"/><Robot name=\"b\"/></Environment>",
            "there are several robots; give a file of one (b)"},
           {"<Robot file=\"made.urdf\"/>", "files name each other in a circle"},
           {kinbody(openrave_body("base", "<RotationMat>1 0 0 0 1 0 0 0 2</RotationMat>")),
            "is no rotation"}}) {
    const InputError error = test::refusal_of([&] { (void)test::read_text(c.text); });
    EXPECT_NE(std::string(error.what()).find(c.message), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("line "), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace prehend
