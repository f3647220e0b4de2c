// Small files in GraspIt!'s formats, written by tests: a hand of two fingers, and an arm.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

namespace prehend::test {

inline void write_graspit_text(const std::filesystem::path& file, const std::string& text) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file) << text;
}

// A body of a box of these sizes [mm], in the file and in an Inventor file beside it.
inline void write_graspit_box(const std::filesystem::path& file, const std::string& size,
                              const std::string& more = "") {
  const std::string name = file.stem().string() + ".iv";
  write_graspit_text(file, "<root>\n<material>rubber</material>\n<mass>200</mass>\n" + more +
                               "<geometryFile type=\"Inventor\">" + name +
                               "</geometryFile>\n</root>\n");
  write_graspit_text(file.parent_path() / name, "#Inventor V2.1 ascii\nCube { " + size + " }\n");
}

// Two fingers of two joints each; the first joints on one breakaway degree of freedom together with
// the second ones of their finger.
inline std::string graspit_hand() {
  return R"(<?xml version="1.0" ?>
<robot type="Hand">
  <palm>palm.xml</palm>
  <dof type="b"><defaultVelocity>1.0</defaultVelocity><maxEffort>2.5e+9</maxEffort>
    <Kp>1.0e+11</Kp><Kd>1.0e+7</Kd><draggerScale>20</draggerScale>
    <breakAwayTorque>0.5</breakAwayTorque></dof>
  <dof type="r"><defaultVelocity>0.5</defaultVelocity><maxEffort>1e+9</maxEffort></dof>
  <chain>
    <transform><translation>30 0 10</translation><rotation>90 x</rotation></transform>
    <joint type="Revolute"><theta>d0*-1+90</theta><d>0</d><a>50</a><alpha>0</alpha>
      <minValue>-90</minValue><maxValue>0</maxValue><viscousFriction>5e+7</viscousFriction></joint>
    <joint type="Revolute"><theta>d0*-0.5-10</theta><d>0</d><a>40</a><alpha>0</alpha>
      <minValue>0</minValue><maxValue>-60</maxValue></joint>
    <link dynamicJointType="Revolute">finger.xml</link>
    <link dynamicJointType="Revolute">finger.xml</link>
  </chain>
  <chain>
    <transform><translation>-30 0 10</translation>
      <rotationMatrix>1 0 0 0 0 1 0 -1 0</rotationMatrix></transform>
    <joint type="Revolute"><theta>d1+90</theta><d>0</d><a>50</a><alpha>0</alpha>
      <minValue>0</minValue><maxValue>90</maxValue></joint>
    <joint type="Revolute"><theta>d1*0.5+-10</theta><d>0</d><a>40</a><alpha>0</alpha>
      <minValue>0</minValue><maxValue>60</maxValue></joint>
    <link dynamicJointType="Universal">finger.xml</link>
  </chain>
  <approachDirection><referenceLocation>0 0 5</referenceLocation><direction>0 0 2</direction>
  </approachDirection>
</robot>
)";
}

// An arm that slides along x and turns about z.
inline std::string graspit_arm() {
  return R"(<robot type="Robot">
  <palm>base.xml</palm>
  <dof type="r"><defaultVelocity>0</defaultVelocity><maxEffort>5e+7</maxEffort></dof>
  <dof><defaultVelocity>0</defaultVelocity><maxEffort>5e+9</maxEffort></dof>
  <chain>
    <transform><fullTransform>(+0.70710678 0 +0.70710678 0)[0 0 +300]</fullTransform></transform>
    <joint type="Prismatic"><theta>0</theta><d>d0*2</d><a>0</a><alpha>-90</alpha>
      <minValue>0</minValue><maxValue>1000</maxValue><CoulombFriction>1e+6</CoulombFriction></joint>
    <joint type="Revolute"><theta>d1</theta><d>0</d><a>0</a><alpha>0</alpha>
      <minValue>-180</minValue><maxValue>180</maxValue></joint>
    <link dynamicJointType="Prismatic">link.xml</link>
    <link dynamicJointType="Revolute">link.xml</link>
  </chain>
</robot>
)";
}

// The hand ROOT/models/robots/pincher/pincher.xml with its bodies.
inline std::filesystem::path written_graspit_hand(const std::filesystem::path& root,
                                                  const std::string& text = graspit_hand()) {
  const std::filesystem::path folder = root / "models/robots/pincher";
  write_graspit_box(folder / "iv/palm.xml", "width 100 height 60 depth 16");
  write_graspit_box(folder / "iv/finger.xml", "width 30 height 8 depth 20");
  write_graspit_text(folder / "pincher.xml", text);
  return folder / "pincher.xml";
}

// The arm ROOT/models/robots/slider/slider.xml with its bodies.
inline std::filesystem::path written_graspit_arm(const std::filesystem::path& root) {
  const std::filesystem::path folder = root / "models/robots/slider";
  write_graspit_box(folder / "iv/base.xml", "width 100 height 100 depth 100");
  write_graspit_box(folder / "iv/link.xml", "width 20 height 20 depth 20");
  write_graspit_text(folder / "slider.xml", graspit_arm());
  return folder / "slider.xml";
}

// An empty folder of the running test.
inline std::filesystem::path graspit_folder() {
  const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "prehend" /
                                       (std::string(test->test_suite_name()) + "." + test->name());
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

}  // namespace prehend::test
