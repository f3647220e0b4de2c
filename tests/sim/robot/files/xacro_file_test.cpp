#include "sim/robot/files/xacro_file.h"

#include <gtest/gtest.h>

#include "tests/sim/robot/files/foreign_files.h"
#include "tests/support/refusal_of.h"

namespace prehend {
namespace {

using test::write_text;

std::string xacro_robot(const std::string& inside) {
  return "<robot name=\"made\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n" + inside +
         "\n</robot>\n";
}

XmlFile expanded(const std::string& inside, const ForeignRobotOptions& options = {}) {
  return expanded_xacro(XmlFile("made.xacro", xacro_robot(inside)), options);
}

// The attributes of all links that the text becomes, in a row.
std::string made_links(const std::string& inside, const ForeignRobotOptions& options = {}) {
  const XmlFile file = expanded(inside, options);
  std::string all;
  for (const XmlElement& link : file.root().children("link")) {
    all += (all.empty() ? "" : ", ") + link.text("name");
  }
  return all;
}

std::string xacro_complaint(const std::string& inside) {
  const std::string what = test::refusal_of([&] { (void)expanded(inside); }).what();
  EXPECT_EQ(what.find('\n'), std::string::npos);
  return what;
}

TEST(XacroFile, PropertiesAreKnownBeforeAndBehind) {
  EXPECT_EQ(made_links(R"x(<xacro:property name="a" value="${b + 1}"/>
                     <xacro:property name="b" value="2"/>
                     <link name="l${a}"/><xacro:property name="a" value="x"/><link name="l${a}"/>
                     <xacro:property name="a" default="y"/><link name="m${a}"/>
                     <xacro:property name="b" value="1"/>
                     <xacro:property name="now" value="${b}" lazy_eval="false"/>
                     <xacro:property name="later" value="${b}"/>
                     <xacro:property name="b" value="5"/><link name="${now}${later}"/>)x"),
            "l3, lx, mx, 15");
}

TEST(XacroFile, MacrosHaveParametersAndBlocks) {
  const XmlFile file = expanded(R"x(
      <xacro:macro name="finger" params="n side:=${n * 10} *origin **inside suffix:='a b'">
        <link name="f${n}_${side}_${suffix}"><xacro:insert_block name="origin"/>
          <xacro:insert_block name="inside"/></link>
      </xacro:macro>
      <xacro:property name="z" value="0.5"/>
      <xacro:finger n="1"><origin xyz="0 0 ${z}"/><x><mass value="1"/><axis/></x></xacro:finger>
      <xacro:call macro="finger" n="2" side="-1"><origin/><x/></xacro:call>)x");
  const auto made = file.root().children("link");
  ASSERT_EQ(made.size(), 2U);
  EXPECT_EQ(made[0].text("name"), "f1_10_a b");
  EXPECT_EQ(made[0]["origin"].text("xyz"), "0 0 0.5");
  ASSERT_EQ(made[0].children().size(), 3U);
  EXPECT_EQ(made[0].children()[2].name(), "axis");
  EXPECT_EQ(made[1].text("name"), "f2_-1_a b");
  EXPECT_EQ(made[1].line(), 4);
}

TEST(XacroFile, NamesOfAMacroStayInside) {
  EXPECT_EQ(made_links(R"x(<xacro:property name="p" value="out"/>
      <xacro:macro name="m" params="q:=^ r:=^|none">
        <xacro:property name="p" value="in"/>
        <xacro:property name="g" value="all" scope="global"/>
        <link name="${p}_${q}_${r}"/></xacro:macro>
      <xacro:property name="q" value="around"/>
      <xacro:m/><link name="${p}_${g}"/>)x"),
            "in_around_none, out_all");
}

TEST(XacroFile, ConditionsChoose) {
  const std::string text = R"x(<xacro:arg name="left" default="false"/>
      <xacro:if value="$(arg left)"><link name="left"/></xacro:if>
      <xacro:unless value="$(arg left)"><link name="right"/></xacro:unless>
      <xacro:if value="${1 + 1 == 2}"><link name="two"/></xacro:if>)x";
  EXPECT_EQ(made_links(text), "right, two");
  ForeignRobotOptions options;
  options.arguments["left"] = "true";
  EXPECT_EQ(made_links(text, options), "left, two");
}

// Blocks may hold calls, and macros call themselves as long as it ends.
TEST(XacroFile, MacrosCallMacros) {
  EXPECT_EQ(made_links(R"x(<xacro:macro name="row" params="k">
        <xacro:if value="${k > 0}"><link name="l${k}"/><xacro:row k="${k - 1}"/></xacro:if>
      </xacro:macro><xacro:row k="3"/>)x"),
            "l3, l2, l1");
}

TEST(XacroFile, IncludesAreFoundBesideAndInPackages) {
  const std::filesystem::path folder = test::test_folder();
  write_text(
      folder / "hand" / "parts" / "finger.xacro",
      xacro_robot("<xacro:macro name=\"finger\" params=\"n\"><link name=\"${n}\"><a x=\"?\"/>"
                  "</link></xacro:macro>"));
  write_text(folder / "hand" / "all.xacro",
             xacro_robot("<xacro:include filename=\"parts/finger.xacro\"/>"));
  const std::filesystem::path main =
      write_text(folder / "hand" / "urdf" / "main.xacro",
                 xacro_robot("<xacro:include filename=\"$(find hand)/all.xacro\"/>"
                             "<xacro:include filename=\"none.xacro\" optional=\"true\"/>"
                             "<xacro:finger n=\"tip\"/>"));
  const XmlFile file = expanded_xacro(XmlFile(main), {});
  EXPECT_EQ(file.root()["link"].text("name"), "tip");
  const std::string why =
      test::refusal_of([&] { (void)file.root()["link"]["a"].number("x"); }).what();
  EXPECT_NE(why.find("main.xacro: finger.xacro line 2, <a>: attribute x must be a number"),
            std::string::npos)
      << why;
}

// As the descriptions of arms have it: limits and names of meshes stand in files of data, which
// macros hand on.
TEST(XacroFile, ReadsFilesOfData) {
  const std::filesystem::path folder = test::test_folder();
  write_text(folder / "arm" / "config" / "limits.yaml",
             "joint_limits:\n  elbow: {max: !degrees 90, mesh: {path: \"elbow.stl\"}}\n");
  const std::filesystem::path main =
      write_text(folder / "arm" / "urdf" / "main.xacro",
                 xacro_robot(R"x(<xacro:arg name="limits" default="$(find arm)/config/limits.yaml"/>
      <xacro:macro name="read" params="file">
        <xacro:property name="data" value="${xacro.load_yaml(file)}"/>
        <xacro:property name="limits" value="${data['joint_limits']}" scope="parent"/>
      </xacro:macro>
      <xacro:read file="$(arg limits)"/>
      <xacro:macro name="part" params="of">
        <link name="${round(of['max'], 3)} ${of.mesh.path} $(optenv NO_SUCH_NAME else)"/>
      </xacro:macro>
      <xacro:part of="${limits['elbow']}"/>
      <xacro:property name="beside" value="${load_yaml('$(find arm)/config/limits.yaml')}"/>
      <link name="${len(beside)}"/>)x"));
  const XmlFile file = expanded_xacro(XmlFile(main), {});
  const auto links = file.root().children("link");
  ASSERT_EQ(links.size(), 2U);
  EXPECT_EQ(links[0].text("name"), "1.571 elbow.stl else");
  EXPECT_EQ(links[1].text("name"), "1");
  const std::string why = xacro_complaint(
      "<xacro:property name=\"a\" value=\"${load_yaml('none.yaml')}\"/>"
      "<link name=\"${a}\"/>");
  EXPECT_NE(why.find("made.xacro: line 2, <link>"), std::string::npos) << why;
  EXPECT_NE(why.find("none.yaml"), std::string::npos) << why;
}

TEST(XacroFile, NamespacesKeepNamesApart) {
  const std::filesystem::path folder = test::test_folder();
  write_text(
      folder / "finger.xacro",
      xacro_robot(
          "<xacro:property name=\"size\" value=\"2\"/>"
          "<xacro:macro name=\"tip\" params=\"n\"><link name=\"${n}${size}\"/></xacro:macro>"
          "<xacro:macro name=\"finger\" params=\"n\"><xacro:tip n=\"${n}\"/></xacro:macro>"));
  const std::filesystem::path main =
      write_text(folder / "main.xacro",
                 xacro_robot("<xacro:property name=\"size\" value=\"1\"/>"
                             "<xacro:include filename=\"finger.xacro\" ns=\"f\"/>"
                             "<xacro:f.finger n=\"a${size}\"/><link name=\"${f.size + size}\"/>"));
  const XmlFile file = expanded_xacro(XmlFile(main), {});
  const auto links = file.root().children("link");
  ASSERT_EQ(links.size(), 2U);
  EXPECT_EQ(links[0].text("name"), "a12");
  EXPECT_EQ(links[1].text("name"), "3");
  const std::string why =
      test::refusal_of([&] {
        (void)expanded_xacro(
            XmlFile(main.string(), xacro_robot("<xacro:include filename=\"finger.xacro\" "
                                               "ns=\"f\"/><xacro:finger n=\"a\"/>")),
            {});
      }).what();
  EXPECT_NE(why.find("no macro of this name (finger)"), std::string::npos) << why;
}

TEST(XacroFile, MistakesAreNamed) {
  const std::vector<std::pair<std::string, std::string>> expected = {
      {"<link name=\"${a}\"/>", "made.xacro: line 2, <link>: no property of this name (a)"},
      {"<xacro:property name=\"a\" value=\"${a}\"/><link name=\"${a}\"/>", "use itself (a)"},
      {"<xacro:other/>", "line 2, <xacro:other>: no macro of this name (other)"},
      {"<xacro:macro name=\"m\" params=\"k\"/><xacro:m/>", "the parameter has no value (k)"},
      {"<xacro:macro name=\"m\"/><xacro:m k=\"1\"/>", "no parameter of this name (k)"},
      {"<xacro:macro name=\"m\" params=\"*b\"/><xacro:m/>", "a block is missing (b)"},
      {"<xacro:macro name=\"m\" params=\"?\"/>", "params must be names"},
      {"<xacro:insert_block name=\"b\"/>", "no block of this name (b)"},
      {"<xacro:if value=\"perhaps\"/>", "must be true, false or a number (perhaps)"},
      {"<link name=\"$(arg side)\"/>", "the argument has no value: state it in \"arguments\""},
      {"<link name=\"$(env HOME)\"/>", "expand the file with xacro first"},
      {"<xacro:include filename=\"none.xacro\"/>", "relative to this one (none.xacro)"},
      {"<xacro:element/>", "line 2, <xacro:element>: attribute xacro:name is missing"},
      {"<xacro:element xacro:name=\"a b\"/>",
       "must have a name that XML knows, not one of xacro (a b)"},
      {"<link><xacro:attribute name=\"xacro:if\" value=\"1\"/></link>",
       "must have a name that XML knows, not one of xacro (xacro:if)"},
      {"<xacro:macro name=\"m\"/>",
       "the file only defines macros; give the one that calls them (m)"},
  };
  for (const auto& [text, words] : expected) {
    EXPECT_NE(xacro_complaint(text).find(words), std::string::npos)
        << text << ": " << xacro_complaint(text);
  }
}

// As in xacro: https://github.com/ros/xacro/wiki#dynamic-element-and-attribute-names
TEST(XacroFile, ElementsAndAttributesMayHaveComputedNames) {
  const XmlFile file = expanded(R"x(
      <xacro:property name="kind" value="link"/>
      <xacro:element xacro:name="${kind}" name="a"><x/>
        <xacro:if value="1"><xacro:attribute name="${kind}_of" value="${1 + 2}"/></xacro:if>
      </xacro:element>)x");
  const auto made = file.root().children("link");
  ASSERT_EQ(made.size(), 1U);
  EXPECT_EQ(made[0].attributes(), (std::vector<std::string>{"name", "link_of"}));
  EXPECT_EQ(made[0].text("link_of"), "3");
  EXPECT_TRUE(made[0].child("x"));
}

// Files of a few lines that would never end.
TEST(XacroFile, GrowthIsBounded) {
  EXPECT_NE(xacro_complaint("<xacro:macro name=\"m\"><xacro:m/></xacro:macro><xacro:m/>")
                .find("at most 60 deep"),
            std::string::npos);
  std::string doubling = "<xacro:property name=\"p0\" value=\"0123456789\"/>";
  std::string calls = "<xacro:macro name=\"m0\"><link name=\"l\"/></xacro:macro>";
  for (int k = 1; k < 40; ++k) {
    const std::string now = std::to_string(k);
    const std::string before = std::to_string(k - 1);
    doubling +=
        "<xacro:property name=\"p" + now + "\" value=\"${p" + before + "}${p" + before + "}\"/>";
    calls += "<xacro:macro name=\"m" + now + "\"><xacro:m" + before + "/><xacro:m" + before +
             "/></xacro:macro>";
  }
  EXPECT_NE(xacro_complaint(doubling + "<link name=\"${p39}\"/>").find("100,000 characters"),
            std::string::npos);
  EXPECT_NE(xacro_complaint(calls + "<xacro:m39/>").find("50000 elements"), std::string::npos);
  // Without any element.
  const std::size_t at = calls.find("<link name=\"l\"/>");
  EXPECT_NE(xacro_complaint(calls.erase(at, 16) + "<xacro:m39/>").find("too many steps"),
            std::string::npos);
}

TEST(XacroFile, IsARobotAsWritten) {
  const std::string text = xacro_robot(
      R"x(<xacro:property name="w" value="0.02"/>
      <xacro:macro name="finger" params="n sign">
        <link name="f${n}"><collision><geometry><box size="0.01 ${w} 0.06"/></geometry></collision></link>
        <joint name="j${n}" type="prismatic"><parent link="palm"/><child link="f${n}"/>
          <origin xyz="${sign * 0.006} 0 0.05"/><axis xyz="${sign} 0 0"/>
          <limit lower="0" upper="${2 * w}" effort="10" velocity="0.1"/></joint>
      </xacro:macro>
      <link name="palm"><collision><geometry><box size="0.1 ${w} 0.04"/></geometry></collision></link>
      <xacro:finger n="1" sign="1"/><xacro:finger n="2" sign="-1"/>)x");
  const Robot robot = test::read_text(text).robots.at(0).robot;
  ASSERT_EQ(robot.dofs.size(), 2U);
  EXPECT_EQ(robot.dofs[0].upper, 0.04);
  EXPECT_EQ(robot.links.size(), 3U);
  EXPECT_EQ(
      test::foreign_complaint(xacro_robot("<xacro:property name=\"t\" value=\"ball\"/>\n"
                                          "<link name=\"a\"/><link name=\"b\"/><joint name=\"j\" "
                                          "type=\"${t}\"><parent link=\"a\"/><child link=\"b\"/>"
                                          "</joint>")),
      "line 3, <joint>: unknown joint type, known are revolute, continuous, prismatic and "
      "fixed (ball)");
}

}  // namespace
}  // namespace prehend
