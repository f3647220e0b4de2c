#include "sim/base/xml/xml_file.h"

#include <functional>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/refusal_of.h"

namespace prehend {
namespace {

std::string refusal(const std::function<void()>& call) { return test::refusal_of(call).what(); }

XmlFile parsed(const std::string& text) { return {"robot.xml", text}; }

constexpr const char* kRobot = R"(<?xml version="1.0"?>
<!-- a comment -->
<robot name="two">
  <joint name="first" value="+1.5" axis=" 0 -1e-3   2 "/>
  <joint name="second"/>
  <mass>
    0.25
  </mass>
  <pose>1 2
    3</pose>
  <title>a &lt; b</title>
</robot>
)";

TEST(XmlFile, ElementsInTheOrderOfTheFile) {
  const XmlFile file = parsed(kRobot);
  const XmlElement root = file.root();
  EXPECT_EQ(root.name(), "robot");
  EXPECT_EQ(root.text("name"), "two");
  ASSERT_EQ(root.children().size(), 5U);
  const auto joints = root.children("joint");
  ASSERT_EQ(joints.size(), 2U);
  EXPECT_EQ(joints[1].text("name"), "second");
  EXPECT_EQ(joints[1].line(), 5);
  EXPECT_EQ(root["joint"].text("name"), "first");
  EXPECT_FALSE(root.child("link"));
}

TEST(XmlFile, NumbersOfAttributesAndContents) {
  const XmlFile file = parsed(kRobot);
  const XmlElement joint = file.root()["joint"];
  EXPECT_EQ(joint.number("value"), 1.5);
  EXPECT_EQ(joint.vector3("axis"), Vector3(0.0, -1e-3, 2.0));
  EXPECT_EQ(joint.number_or("effort", 7.0), 7.0);
  EXPECT_EQ(joint.vector3_or("origin", Vector3::Ones()), Vector3::Ones());
  EXPECT_EQ(joint.text_or("type", "fixed"), "fixed");
  EXPECT_EQ(file.root()["mass"].content_number(), 0.25);
  EXPECT_EQ(file.root()["pose"].content_numbers(), (std::vector<double>{1.0, 2.0, 3.0}));
  EXPECT_EQ(file.root()["title"].content(), "a < b");
}

TEST(XmlFile, WhatDoesNotFitIsNamedWithItsLine) {
  const XmlFile file = parsed(kRobot);
  const XmlElement root = file.root();
  const XmlElement joint = root["joint"];
  EXPECT_EQ(refusal([&] { joint.number("name"); }),
            "robot.xml: line 4, <joint>: attribute name must be a number, at most 1e30 in size "
            "(first)");
  EXPECT_EQ(refusal([&] { joint.vector3("value"); }),
            "robot.xml: line 4, <joint>: attribute value must have three numbers (+1.5)");
  EXPECT_EQ(refusal([&] { root["joint"].text("type"); }),
            "robot.xml: line 4, <joint>: attribute type is missing");
  EXPECT_EQ(refusal([&] { root["link"]; }), "robot.xml: line 3, <robot>: <link> is missing inside");
  EXPECT_EQ(refusal([&] { root["title"].content_number(); }),
            "robot.xml: line 11, <title>: the content must be a number, at most 1e30 in size "
            "(a < b)");
}

TEST(XmlFile, NumbersThatAreNone) {
  for (const char* number : {"nan", "inf", "1e31", "1.0x", "--1", "+-1", "0x10", "1,5"}) {
    const XmlFile file = parsed("<a v=\"" + std::string(number) + "\"/>");
    EXPECT_NE(refusal([&] { file.root().number("v"); }), "") << number;
  }
}

TEST(XmlFile, NotWellFormed) {
  EXPECT_EQ(refusal([] { parsed("<a>\n<b>\n</a>"); }),
            "robot.xml: line 2: a tag is closed that is not open, or stays open");
  EXPECT_EQ(refusal([] { parsed("<a>\n<b c=1/>\n</a>"); }),
            "robot.xml: line 2: an attribute is not written as name=\"value\"");
  EXPECT_EQ(refusal([] { parsed(""); }), "robot.xml: there is no element");
  EXPECT_EQ(refusal([] { parsed("<!-- nothing -->"); }), "robot.xml: there is no element");
  EXPECT_NE(refusal([] { parsed("<a"); }), "");
  EXPECT_NE(refusal([] { parsed("{}"); }), "");
}

TEST(XmlFile, EntitiesAreNotDefined) {
  // Each would become a thousand of the one before it; the last would be another file.
  EXPECT_EQ(
      refusal([] {
        parsed("<?xml version=\"1.0\"?>\n<!DOCTYPE a [\n<!ENTITY b \"cccccccccc\">\n]><a>&b;</a>");
      }),
      "robot.xml: line 3: entities must not be defined here");
  EXPECT_EQ(refusal([] { parsed("<!DOCTYPE a [<!ENTITY b SYSTEM \"/etc/passwd\">]><a>&b;</a>"); }),
            "robot.xml: line 1: entities must not be defined here");
}

TEST(XmlFile, NestingHasAnEnd) {
  std::string text;
  for (int i = 0; i < 100000; ++i) text += "<a>";
  EXPECT_EQ(refusal([&] { parsed(text); }).rfind("robot.xml: line 1: elements are nested", 0), 0U);
}

}  // namespace
}  // namespace prehend
