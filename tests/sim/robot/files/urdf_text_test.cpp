#include "sim/robot/files/urdf_text.h"

#include <algorithm>
#include <random>

#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/robot/files/platform_file.h"
#include "sim/robot/files/robot_file.h"
#include "tests/sim/robot/files/foreign_files.h"

namespace prehend {
namespace {

using test::test_folder;
using test::write_text;

Platform written_and_read(const Platform& platform) {
  const std::filesystem::path folder = test_folder();
  for (const RobotTextFile& file : urdf_text(platform, "made.urdf")) {
    write_text(folder / file.name, file.content);
  }
  return load_platform(folder / "made.urdf");
}

double value_between(double lower, double upper, std::mt19937& random) {
  return lower + (upper - lower) * (static_cast<double>(random()) / 4294967296.0);
}

const Joint& joint_called(const Robot& robot, const std::string& name) {
  for (const Joint& joint : robot.joints) {
    if (joint.name == name) return joint;
  }
  ADD_FAILURE() << "no joint " << name;
  return robot.joints.at(0);
}

const Link& link_called(const Robot& robot, const std::string& name) {
  for (const Link& link : robot.links) {
    if (link.name == name) return link;
  }
  ADD_FAILURE() << "no link " << name;
  return robot.links.at(0);
}

// Meshes are read in single precision.
constexpr double kSinglePrecision = 2e-6;

// Sets the joints of `again` to the values that those of `robot` have, and compares where all
// vertices are. A joint J or link L of `robot` is called joint_name(J) or link_name(L) in `again`.
template <typename JointName, typename LinkName>
void expect_same_places(const Robot& robot, const Robot& again, const JointName& joint_name,
                        const LinkName& link_name) {
  ASSERT_EQ(again.joints.size(), robot.joints.size());
  ASSERT_EQ(again.dofs.size(), robot.dofs.size());
  std::mt19937 random(3);
  for (int n = 0; n < 20; ++n) {
    std::vector<double> dofs;
    for (const DegreeOfFreedom& dof : robot.dofs) {
      dofs.push_back(value_between(dof.lower, dof.upper, random));
    }
    const std::vector<double> values = joint_values(robot, dofs);
    std::vector<double> dofs_again(again.dofs.size());
    for (std::size_t j = 0; j < robot.joints.size(); ++j) {
      const Joint& joint = joint_called(again, joint_name(robot.joints[j]));
      dofs_again[index(joint.dof)] = (values[j] - joint.offset) / joint.ratio;
    }
    std::vector<Pose> X_BL;
    std::vector<Pose> X_again;
    link_poses(robot, values, X_BL);
    link_poses(again, joint_values(again, dofs_again), X_again);
    for (std::size_t l = 0; l < robot.links.size(); ++l) {
      const Link& link = robot.links[l];
      const Link& other = link_called(again, link_name(link));
      const Pose& X_other = X_again[static_cast<std::size_t>(&other - again.links.data())];
      const Bounds here = bounds(transformed(link.mesh, X_BL[l]));
      const Bounds there = bounds(transformed(other.mesh, X_other));
      EXPECT_LT((here.lower - there.lower).norm(), kSinglePrecision) << link.name;
      EXPECT_LT((here.upper - there.upper).norm(), kSinglePrecision) << link.name;
      EXPECT_EQ(other.material, link.material);
      EXPECT_NEAR(other.inertial.mass, link.inertial.mass, 1e-12);
    }
  }
}

const std::string& joint_in_driver(const Joint& joint) { return driver_name(joint); }

bool has_cups(const Platform& platform) {
  return std::any_of(platform.robots.begin(), platform.robots.end(), [](const MountedRobot& one) {
    return one.robot.hand && !one.robot.hand->cups.empty();
  });
}

TEST(UrdfText, SuctionCupsAreRefused) {
  for (const char* name : {"suction_cup_30", "ur5e_suction"}) {
    const Platform platform = find_platform(name);
    ASSERT_TRUE(has_cups(platform));
    EXPECT_THROW((void)urdf_text(platform, "made.urdf"), InputError) << name;
  }
}

TEST(UrdfText, LibraryRobotsReadBackWithEqualPositions) {
  for (const std::string& name : library_robot_names()) {
    SCOPED_TRACE(name);
    const Platform platform = find_platform(name);
    if (has_cups(platform)) continue;
    const Platform again = written_and_read(platform);
    ASSERT_EQ(again.robots.size(), 1U);
    const Robot& robot = platform.robots[0].robot;
    const Robot& other = again.robots[0].robot;
    expect_same_places(robot, other, joint_in_driver, [](const Link& link) { return link.name; });
    ASSERT_EQ(other.hand.has_value(), robot.hand.has_value());
    if (!robot.hand) continue;
    EXPECT_LT((other.hand->approach - robot.hand->approach).norm(), 1e-12);
    ASSERT_EQ(other.hand->preshapes.size(), robot.hand->preshapes.size());
    // A preshape is the same posture of all joints.
    for (std::size_t p = 0; p < robot.hand->preshapes.size(); ++p) {
      const std::vector<double> values = joint_values(robot, robot.hand->preshapes[p].dofs);
      const std::vector<double> others = joint_values(other, other.hand->preshapes[p].dofs);
      for (std::size_t j = 0; j < values.size(); ++j) {
        const Joint& same = joint_called(other, driver_name(robot.joints[j]));
        EXPECT_NEAR(others[static_cast<std::size_t>(&same - other.joints.data())], values[j], 1e-12)
            << same.name;
      }
    }
    for (std::size_t d = 0; d < robot.dofs.size(); ++d) {
      EXPECT_EQ(other.dofs[d].coupling, robot.dofs[d].coupling) << robot.dofs[d].name;
    }
  }
}

TEST(UrdfText, PlatformsReadBackWithEqualPositions) {
  for (const std::string& name : library_platform_names()) {
    SCOPED_TRACE(name);
    const Platform platform = find_platform(name);
    if (has_cups(platform)) continue;
    const Platform again = written_and_read(platform);
    ASSERT_EQ(again.robots.size(), 2U);
    EXPECT_TRUE(again.robots[1].robot.hand);
    // ROBOT/NAME was written as ROBOT_NAME, and is read as a name of the arm or the hand.
    const Robot other = assemble(again).robot;
    const Robot whole = assemble(platform).robot;
    // ROBOT/NAME was written as ROBOT_NAME, but for joints that the driver has a name for, and is
    // read as a name of the arm or the hand.
    const auto with_robot = [&](const auto& all, const std::string& name) {
      for (const auto& one : all) {
        if (one.name == "hand/" + name) return one.name;
      }
      return "arm/" + name;
    };
    const auto written = [](std::string name) {
      name[name.find('/')] = '_';
      return name;
    };
    expect_same_places(
        whole, other,
        [&](const Joint& joint) {
          const bool has_name = !joint.name.ends_with("/" + joint.driver_name);
          return with_robot(other.joints, has_name ? joint.driver_name : written(joint.name));
        },
        [&](const Link& link) { return with_robot(other.links, written(link.name)); });
  }
}

const RobotFrame& frame_called(const Robot& robot, const std::string& name) {
  for (const RobotFrame& frame : robot.frames) {
    if (frame.name == name) return frame;
  }
  ADD_FAILURE() << "no frame " << name;
  return robot.frames.at(0);
}

// Tool frames have no geometry, and links that others carry have frames of their own: both are
// there after two conversions, and meshes are written in the frames in which they were read.
TEST(UrdfText, KeepsFramesWithoutGeometryAndTurnedLinks) {
  const std::string text = test::urdf(
      "<link name=\"world\"/>" + test::box_link("base") + test::box_link("arm") +
      test::box_link("turned", "0.1 0.2 0.3", "0.5 0 0") + "<link name=\"tool0\"/>" +
      "<link name=\"my_TCP\"/>" +
      test::urdf_joint("stands", "fixed", "world", "base", "<origin xyz=\"0 0 1\"/>") +
      test::urdf_joint("turns", "revolute", "base", "arm",
                       std::string("<axis xyz=\"0 0 1\"/>") + test::kLimit) +
      test::urdf_joint("holds", "fixed", "arm", "turned",
                       "<origin xyz=\"0.1 0 0\" rpy=\"0 0 1.5707963267948966\"/>") +
      test::urdf_joint("ends", "fixed", "turned", "tool0", "<origin xyz=\"0 0 0.25\"/>") +
      test::urdf_joint("reaches", "fixed", "tool0", "my_TCP", "<origin xyz=\"0 0 0.1\"/>"));
  Platform platform = test::read_text(text);
  const Robot first = platform.robots.at(0).robot;
  EXPECT_EQ(frame_called(first, "tool0").role, FrameRole::flange);
  EXPECT_EQ(frame_called(first, "my_TCP").role, FrameRole::tool);
  EXPECT_LT((frame_called(first, "my_TCP").X_AF.translation() - Vector3(0.1, 0.0, 0.35)).norm(),
            1e-12);
  for (int n = 0; n < 2; ++n) {
    platform = written_and_read(platform);
    const Robot& again = platform.robots.at(0).robot;
    for (const char* name : {"tool0", "my_TCP", "turned"}) {
      const RobotFrame& before = frame_called(first, name);
      const RobotFrame& after = frame_called(again, name);
      EXPECT_EQ(after.joint, before.joint) << name;
      EXPECT_LT((after.X_AF.matrix() - before.X_AF.matrix()).norm(), 1e-12) << name;
    }
    expect_same_places(first, again, joint_in_driver, [](const Link& link) { return link.name; });
  }
  const std::vector<RobotTextFile> files = urdf_text(test::read_text(text), "made.urdf");
  for (const RobotTextFile& file : files) {
    if (file.name != "made_meshes/turned.obj") continue;
    EXPECT_NE(file.content.find("v 0.45 -0.1 -0.15"), std::string::npos) << file.content;
  }
}

// The joint's own value is that of its degree of freedom, whatever it was before.
// The file does not say it: it shows in the axes.
TEST(UrdfText, ArmsKeepTheirClosedForm) {
  for (const char* name : {"puma560", "ur5e"}) {
    const Platform again = written_and_read(find_platform(name));
    ASSERT_EQ(again.robots.size(), 1U) << name;
    const Chain& chain = again.robots.front().robot.chains.front();
    EXPECT_NE(chain.closed_form, ClosedForm::none) << name;
    EXPECT_EQ(chain.closed_form, find_robot(name).chains.front().closed_form) << name;
  }
  const Platform redundant = written_and_read(find_platform("panda_arm"));
  for (const Chain& chain : redundant.robots.front().robot.chains) {
    EXPECT_EQ(chain.closed_form, ClosedForm::none);
  }
}

// A degree of freedom that becomes the value of a joint at the ratio r has 1 / r^2 of its gains:
// the same efforts on the joint.
TEST(UrdfText, KeepsGainsAndSprings) {
  Platform platform = find_platform("barrett");
  Robot& robot = platform.robots[0].robot;
  robot.joints[1].spring = {.stiffness = 3.5, .rest = -0.2};
  robot.dofs[1].stiffness = 8.0;
  robot.dofs[1].damping = 0.5;
  const int dof = robot.dofs.size() > 1 ? 1 : 0;
  for (Joint& joint : robot.joints) {
    if (joint.dof == dof) joint.ratio *= 2.0;
  }
  const Robot again = written_and_read(platform).robots[0].robot;
  const Joint& sprung = joint_called(again, robot.joints[1].name);
  EXPECT_EQ(sprung.spring.stiffness, 3.5);
  EXPECT_EQ(sprung.spring.rest, -0.2);
  EXPECT_EQ(again.dofs[1].stiffness, 2.0);
  EXPECT_EQ(again.dofs[1].damping, 0.125);
  EXPECT_EQ(again.dofs[0].stiffness, robot.dofs[0].stiffness);
  EXPECT_FALSE(again.dofs[0].damping);
}

TEST(UrdfText, DegreesOfFreedomBecomeJointValues) {
  Robot robot = find_robot("parallel_jaw");
  for (Joint& joint : robot.joints) {
    joint.ratio *= -2.0;
    joint.offset = 0.25 * joint.lower + 0.75 * joint.upper;
  }
  for (DegreeOfFreedom& dof : robot.dofs) {
    dof.upper = 0.0;
    dof.lower = -1e-3;
    dof.initial = -1e-3;
  }
  robot.hand.reset();
  Platform platform;
  platform.name = "changed";
  platform.robots.push_back({.name = "changed", .robot = robot});
  const Robot other = written_and_read(platform).robots.at(0).robot;
  const double value = robot.joints[0].ratio * -1e-3 + robot.joints[0].offset;
  EXPECT_NEAR(other.dofs[0].initial, value, 1e-12);
  EXPECT_NEAR(other.dofs[0].closing_velocity, -2.0 * robot.dofs[0].closing_velocity, 1e-12);
}

TEST(UrdfText, NamesMayHoldAnything) {
  Platform platform = find_platform("parallel_jaw");
  Robot& robot = platform.robots[0].robot;
  robot.links[0].name = "a <b> & \"c\"/d";
  robot.links[1].name = "a _b_ & \"c\"/d";
  const Robot other = written_and_read(platform).robots.at(0).robot;
  EXPECT_EQ(other.links[0].name, robot.links[0].name);
  EXPECT_EQ(other.links[1].name, robot.links[1].name);
}

// Names of other encodings, as a URDF file in Latin-1 has.
TEST(UrdfText, IsUtf8WhateverNamesHold) {
  Platform platform = find_platform("parallel_jaw");
  platform.name = "Zange f\xFCr T\xF6pfe";
  Robot& robot = platform.robots[0].robot;
  robot.links[0].name =
      "B\xFC"
      "gel";
  const std::string xml = urdf_text(platform, "made.urdf").back().content;
  EXPECT_NE(xml.find("<robot name=\"Zange f\uFFFDr T\uFFFDpfe\">"), std::string::npos) << xml;
  EXPECT_EQ(written_and_read(platform).robots.at(0).robot.links[0].name, "B\uFFFDgel");
}

}  // namespace
}  // namespace prehend
