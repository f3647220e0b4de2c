#include "sim/robot/files/robot_text.h"

#include "sim/base/index.h"
#include "sim/robot/files/platform_file.h"
#include "sim/robot/files/robot_file.h"
#include "tests/sim/robot/files/foreign_files.h"
#include "tests/sim/robot/files/same_robot.h"
#include "tests/support/refusal_of.h"

namespace prehend {
namespace {

using test::box_link;
using test::kLimit;
using test::test_folder;
using test::urdf_joint;
using test::write_text;

TEST(RobotText, LibraryRobotsReadBackAsTheSame) {
  const std::filesystem::path folder = test_folder();
  for (const std::string& name : library_robot_names()) {
    const Robot robot = find_robot(name);
    test::expect_same_robot(load_robot(write_text(folder / "robot.json", robot_text(robot))),
                            robot);
  }
}

TEST(RobotText, AHandWithoutPreshapesReadsBackAsTheSame) {
  Robot robot = find_robot("barrett");
  robot.hand->preshapes.clear();
  const std::filesystem::path file = write_text(test_folder() / "robot.json", robot_text(robot));
  test::expect_same_robot(load_robot(file), robot);
}

TEST(RobotText, GainsAndSpringsReadBackAsTheSame) {
  Robot robot = find_robot("barrett");
  robot.dofs[0].stiffness = 0.0;
  robot.dofs[1].stiffness = 12.5;
  robot.dofs[1].damping = 0.25;
  robot.joints[1].spring = {.stiffness = 3.5, .rest = -0.2};
  const std::filesystem::path file = write_text(test_folder() / "robot.json", robot_text(robot));
  test::expect_same_robot(load_robot(file), robot);
}

TEST(RobotText, LinkagesReadBackAsTheSame) {
  Robot robot = find_robot("robotiq_2f85");
  Joint& coupler = robot.joints[1];
  coupler.ratio = 0.0;
  coupler.across = 2;
  coupler.ahead = -1.5;
  const std::filesystem::path file = write_text(test_folder() / "robot.json", robot_text(robot));
  test::expect_same_robot(load_robot(file), robot);
  robot.joints[1].across = 1;
  const std::filesystem::path own = write_text(test_folder() / "own.json", robot_text(robot));
  EXPECT_EQ(test::refusal_of([&] { (void)load_robot(own); }).problem(),
            "must be another joint that the same degree of freedom drives");
}

TEST(RobotText, PlatformsReadBackAsTheSame) {
  for (const std::string& name : library_platform_names()) {
    const std::filesystem::path folder = test_folder();
    const Platform platform = find_platform(name);
    for (const RobotTextFile& file : platform_text(platform, "whole.json")) {
      write_text(folder / file.name, file.content);
    }
    const Platform again = load_platform(folder / "whole.json");
    test::expect_same_robot(assemble(again).robot, assemble(platform).robot);
  }
}

// Links that share the base, unknown masses, branches, couplings and exempt pairs.
TEST(RobotText, WhatUrdfHasReadsBackAsTheSame) {
  const std::string text = test::urdf(
      box_link("base") + box_link("lid") + box_link("a") + box_link("b") + box_link("nail") +
      urdf_joint("fixed", "fixed", "base", "lid", "<origin xyz=\"0 0 1\" rpy=\"0.1 0.2 0.3\"/>") +
      urdf_joint(
          "ja", "revolute", "lid", "a",
          std::string("<origin xyz=\"0 1 0\" rpy=\"1 2 3\"/><axis xyz=\"1 2 3\"/>") + kLimit) +
      urdf_joint("jb", "revolute", "lid", "b",
                 std::string(kLimit) + "<mimic joint=\"ja\" multiplier=\"0.7\" offset=\"0.1\"/>") +
      urdf_joint("nailed", "fixed", "a", "nail", "<origin xyz=\"0 0 1\"/>"));
  const std::filesystem::path folder = test_folder();
  write_text(folder / "made.urdf", text);
  write_text(folder / "made.prehend.json", R"({"exempt_collisions": [["a", "b"], ["b", "nail"]]})");
  const Robot robot = find_robot((folder / "made.urdf").string());
  ASSERT_EQ(robot.exempt_pairs.size(), 2U);
  EXPECT_EQ(robot.links[0].inertial.mass, 0.0);
  const std::filesystem::path file = write_text(folder / "robot.json", robot_text(robot));
  test::expect_same_robot(load_robot(file), robot);
}

TEST(RobotText, RotationsMustBeRotations) {
  const std::filesystem::path folder = test_folder();
  std::string text = robot_text(find_robot("puma560"));
  const std::size_t at = text.find("\"rotation\": ");
  ASSERT_NE(at, std::string::npos);
  text.insert(text.find_first_of("-0123456789", at), "5");
  EXPECT_THROW(load_robot(write_text(folder / "robot.json", text)), InputError);
}

}  // namespace
}  // namespace prehend
