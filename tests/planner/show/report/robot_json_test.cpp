// Robots as a report's page moves them stand where ours do.
#include "planner/show/report/robot_json.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "planner/plan/path/grasp_motion.h"
#include "sim/base/index.h"
#include "sim/robot/files/platform_file.h"
#include "sim/robot/files/robot_file.h"
#include "sim/trial/candidate.h"
#include "sim/trial/trial.h"
#include "tests/planner/show/report/unpack.h"
#include "tests/support/library_scenes.h"
#include "tests/support/trees.h"

namespace prehend {
namespace {

using test::frames_in;
using test::pose_in;

// Poses are written to seven digits: that much over a robot of a few metres.
constexpr double kNear = 1e-5;

std::vector<double> random_joints(const Robot& robot, Random& random) {
  std::vector<double> joints;
  for (const Joint& joint : robot.joints)
    joints.push_back(random.uniform(joint.lower, joint.upper));
  return joints;
}

// Where a point of the frame half a metre from its origin goes, at most.
double distance(const Pose& a, const Pose& b) {
  double most = (a.translation() - b.translation()).norm();
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3 p = 0.5 * Vector3::Unit(axis);
    most = std::max(most, (a * p - b * p).norm());
  }
  return most;
}

Pose frame_at(const std::vector<Pose>& frames, int joint) {
  return joint < 0 ? Pose::Identity() : frames[index(joint)];
}

void expect_same_motion(const Robot& robot, const nlohmann::json& json, int postures) {
  Random random(5);
  ASSERT_EQ(json["joints"].size(), robot.joints.size());
  for (int i = 0; i < postures; ++i) {
    const std::vector<double> joints = random_joints(robot, random);
    std::vector<Pose> expected;
    joint_poses(robot, joints, expected);
    const std::vector<Pose> found = frames_in(json, joints);
    for (std::size_t j = 0; j < expected.size(); ++j) {
      EXPECT_LT(distance(found[j], expected[j]), kNear) << robot.joints[j].name;
    }
  }
}

void expect_same_link(const Link& link, const nlohmann::json& json) {
  EXPECT_EQ(json["name"], link.name);
  EXPECT_EQ(json["joint"], link.joint);
  EXPECT_EQ(json["material"], link.material);
  const TriangleMesh mesh = test::unpacked(json["mesh"]);
  EXPECT_EQ(mesh.triangles, link.mesh.triangles);
  ASSERT_EQ(mesh.vertices.size(), link.mesh.vertices.size());
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    EXPECT_LT((mesh.vertices[v] - link.mesh.vertices[v]).norm(), 1e-6) << link.name;
  }
}

// Every corner of the link that the page draws, where it draws it.
void expect_same_place(const Link& link, const Pose& X_BL, const nlohmann::json& json,
                       const Pose& X_BD) {
  const TriangleMesh drawn = test::unpacked(json["mesh"]);
  ASSERT_EQ(drawn.vertices.size(), link.mesh.vertices.size()) << link.name;
  for (std::size_t v = 0; v < drawn.vertices.size(); ++v) {
    const Vector3 expected = X_BL * link.mesh.vertices[v];
    ASSERT_LT((X_BD * drawn.vertices[v] - expected).norm(), kNear) << link.name;
  }
}

TEST(RobotJson, TreesOfAnyAxesMoveAsOurs) {
  Random random(6);
  for (int i = 0; i < 10; ++i) {
    const Robot robot = test::random_tree(random, 6);
    expect_same_motion(robot, nlohmann::json::parse(robot_json(robot).dump()), 10);
  }
}

TEST(RobotJson, EveryLibraryRobotMovesAsItDoesHere) {
  ASSERT_GE(library_robot_names().size(), 5U);
  for (const std::string& name : library_robot_names()) {
    SCOPED_TRACE(name);
    const Robot robot = find_robot(name);
    const nlohmann::json json = robot_json(robot);
    EXPECT_EQ(json["name"], robot.name);
    expect_same_motion(robot, json, 20);
    ASSERT_EQ(json["links"].size(), robot.links.size());
    for (std::size_t l = 0; l < robot.links.size(); ++l) {
      expect_same_link(robot.links[l], json["links"][l]);
    }
  }
}

TEST(RobotJson, EveryLibraryPlatformMovesAsItDoesHere) {
  ASSERT_FALSE(library_platform_names().empty());
  for (const std::string& name : library_platform_names()) {
    SCOPED_TRACE(name);
    const Robot robot = assemble(find_platform(name)).robot;
    expect_same_motion(robot, robot_json(robot), 20);
  }
}

class ArmJson : public testing::TestWithParam<const char*> {};

TEST_P(ArmJson, ArmAndHandStandWhereTheyDoHere) {
  const CompiledScene scene = test::compiled_library_scene(GetParam());
  const CompiledArm& arm = *scene.arm;
  const nlohmann::json json = arm_json(arm);
  const nlohmann::json hand = robot_json(scene.scene.hand);
  expect_same_motion(arm.robot(), json, 5);
  Random random(6);
  for (int i = 0; i < 10; ++i) {
    const std::vector<double> joints = random_joints(arm.robot(), random);
    std::vector<Pose> expected;
    arm_link_poses(arm, joints, expected);
    const std::vector<Pose> frames = frames_in(json, joints);
    std::size_t drawn = 0;
    for (std::size_t l = 0; l < arm.robot().links.size(); ++l) {
      if (arm.is_hand_link(link_id(l))) continue;
      const nlohmann::json& link = json["links"][drawn++];
      expect_same_place(arm.robot().links[l], expected[l], link, frame_at(frames, link["joint"]));
    }
    EXPECT_EQ(drawn, json["links"].size());
    // The hand, on the frame that carries it, with its own part of the joints.
    const Pose X_BH = frame_at(frames, json["hand_joint"]) * pose_in(json["X_hand"]);
    const auto first = joints.begin() + json["first_hand_joint"].get<std::ptrdiff_t>();
    const std::vector<double> own(
        first, first + static_cast<std::ptrdiff_t>(scene.scene.hand.joints.size()));
    const std::vector<Pose> hand_frames = frames_in(hand, own);
    const std::size_t palm = index(arm.hand_part().first_link);
    for (std::size_t l = 0; l < scene.scene.hand.links.size(); ++l) {
      const nlohmann::json& link = hand["links"][l];
      expect_same_place(arm.robot().links[palm + l], expected[palm + l], link,
                        X_BH * frame_at(hand_frames, link["joint"]));
    }
  }
}

TEST_P(ArmJson, TheHandOfAMotionIsWhereTheArmHoldsIt) {
  const CompiledScene scene = test::compiled_library_scene(GetParam());
  const nlohmann::json json = arm_json(*scene.arm);
  EXPECT_EQ(json["start"].get<std::vector<double>>(),
            joint_values(scene.arm->robot(), scene.arm->start));
  Random random(7);
  Trajectory path;
  for (int i = 0; i < 10; ++i) {
    path.times.push_back(i);
    path.positions.push_back(random_joints(scene.arm->robot(), random));
  }
  path.segments = {{"transfer", 0, 9}};
  const GraspMotion motion = grasp_motion(scene, {}, {}, &path);
  ASSERT_EQ(motion.frames.size(), 10U);
  for (const MotionFrame& frame : motion.frames) {
    const std::vector<Pose> frames = frames_in(json, frame.arm_joints);
    const Pose X_WH =
        pose_in(json["X"]) * frame_at(frames, json["hand_joint"]) * pose_in(json["X_hand"]);
    EXPECT_LT(distance(X_WH, scene.scene.object.X_WO * frame.X_OH), kNear);
    const auto first = frame.arm_joints.begin() + json["first_hand_joint"].get<std::ptrdiff_t>();
    EXPECT_TRUE(std::equal(frame.joints.begin(), frame.joints.end(), first));
    EXPECT_EQ(frame.joints.size(), scene.scene.hand.joints.size());
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, ArmJson,
                         testing::Values("mug_on_table", "cluttered_table", "shelf", "living_room"),
                         [](const auto& scene) { return std::string(scene.param); });

TEST(Rounded, ToAMultipleOfTheStep) {
  EXPECT_EQ(rounded(0.12345678), 0.123457);
  EXPECT_EQ(rounded(-2.5, 1.0), -3.0);
  for (const double large : {1e300, -1e305, std::numeric_limits<double>::max()}) {
    EXPECT_EQ(rounded(large), large);  // the scaled value need not be a double
  }
}

TEST(Significant, KeepsSixDigitsOfAnySize) {
  EXPECT_EQ(significant(123456.789), 123457.0);
  EXPECT_EQ(significant(-1.23456789e-200), -1.23457e-200);
  EXPECT_EQ(significant(0.0), 0.0);
}

}  // namespace
}  // namespace prehend
