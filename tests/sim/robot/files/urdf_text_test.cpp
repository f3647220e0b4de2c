#include "sim/robot/files/urdf_text.h"

#include <random>

#include "sim/base/index.h"
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
// vertices are. A name N of `robot` is called renamed(N) in `again`.
template <typename Renamed>
void expect_same_places(const Robot& robot, const Robot& again, const Renamed& renamed) {
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
      const Joint& joint = joint_called(again, renamed(robot.joints[j].name));
      dofs_again[index(joint.dof)] = (values[j] - joint.offset) / joint.ratio;
    }
    std::vector<Pose> X_BL;
    std::vector<Pose> X_again;
    link_poses(robot, values, X_BL);
    link_poses(again, joint_values(again, dofs_again), X_again);
    for (std::size_t l = 0; l < robot.links.size(); ++l) {
      const Link& link = robot.links[l];
      const Link& other = link_called(again, renamed(link.name));
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

TEST(UrdfText, LibraryRobotsReadBackWithEqualPositions) {
  for (const std::string& name : library_robot_names()) {
    SCOPED_TRACE(name);
    const Platform platform = find_platform(name);
    const Platform again = written_and_read(platform);
    ASSERT_EQ(again.robots.size(), 1U);
    const Robot& robot = platform.robots[0].robot;
    const Robot& other = again.robots[0].robot;
    expect_same_places(robot, other, [](const std::string& same) { return same; });
    ASSERT_EQ(other.hand.has_value(), robot.hand.has_value());
    if (!robot.hand) continue;
    EXPECT_LT((other.hand->approach - robot.hand->approach).norm(), 1e-12);
    ASSERT_EQ(other.hand->preshapes.size(), robot.hand->preshapes.size());
    // A preshape is the same posture of all joints.
    for (std::size_t p = 0; p < robot.hand->preshapes.size(); ++p) {
      const std::vector<double> values = joint_values(robot, robot.hand->preshapes[p].dofs);
      const std::vector<double> others = joint_values(other, other.hand->preshapes[p].dofs);
      for (std::size_t j = 0; j < values.size(); ++j) {
        const Joint& same = joint_called(other, robot.joints[j].name);
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
    const Platform again = written_and_read(platform);
    ASSERT_EQ(again.robots.size(), 2U);
    EXPECT_TRUE(again.robots[1].robot.hand);
    // ROBOT/NAME was written as ROBOT_NAME, and is read as a name of the arm or the hand.
    const Robot other = assemble(again).robot;
    expect_same_places(assemble(platform).robot, other, [&](std::string renamed) {
      renamed[renamed.find('/')] = '_';
      for (const Link& link : other.links) {
        if (link.name == "hand/" + renamed) return link.name;
      }
      for (const Joint& joint : other.joints) {
        if (joint.name == "hand/" + renamed) return joint.name;
      }
      return "arm/" + renamed;
    });
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
