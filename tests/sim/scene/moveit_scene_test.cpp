// Scenes and requests of MoveIt.
#include "sim/scene/moveit_scene.h"

#include <fstream>

#include <gtest/gtest.h>

#include "sim/base/input_error.h"
#include "sim/base/json/yaml_file.h"
#include "sim/scene/compiled_scene.h"
#include "sim/scene/scene_file.h"
#include "tests/support/refusal_of.h"

namespace prehend {
namespace {

// What a call that is refused says.
template <typename Call>
std::string refusal(const Call& call) {
  return test::refusal_of(call).what();
}

std::filesystem::path write_yaml(const std::string& text) {
  const std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
  const std::filesystem::path file = testing::TempDir() + "/moveit_" + name + ".yaml";
  std::ofstream(file) << text;
  return file;
}

const char* const kCans = R"(
robot_model_name: panda
robot_state:
  joint_state:
    name: [panda_joint1, panda_joint2, panda_finger_joint1, panda_finger_joint2, wheel]
    position: [0.5, -0.7, 0.065, 0.065, 3]
  multi_dof_joint_state:
    transforms: [{translation: [0, 0, 0.25], rotation: [0, 0, 0.7071067811865476, 0.7071067811865476]}]
world:
  collision_objects:
    - id: shelf
      primitives:
        - {type: box, dimensions: [1.2, 1, 0.04]}
        - {type: box, dimensions: [0.04, 1, 0.5]}
      primitive_poses:
        - {position: [1, 2, 3], orientation: [0, 0, 0, 1]}
        - {position: {x: 1, y: 2, z: 3.2}, orientation: {x: 0, y: 0, z: 1, w: 0}}
    - id: can
      pose: {position: [0.5, 0, 0.1], orientation: [0, 0, 0, 1]}
      primitives:
        - {type: cylinder, dimensions: [0.14, 0.03]}
)";

TEST(MoveitScene, CollisionObjectsAreTheObjectAndObstacles) {
  const Scene scene = load_scene(write_yaml(kCans), {.choice = {.object = "can"}});
  EXPECT_EQ(scene.object.name, "can");
  EXPECT_EQ(scene.object.X_WO.translation(), Vector3(0.5, 0.0, 0.1));
  const Vector3 size = bounds(scene.object.mesh).size();
  EXPECT_NEAR(size.z(), 0.14, 1e-12);
  EXPECT_NEAR(size.x(), 0.06, 1e-12);
  ASSERT_EQ(scene.obstacles.size(), 1U);
  EXPECT_EQ(scene.obstacles[0].name, "shelf");
  const Bounds shelf = bounds(scene.obstacles[0].mesh);
  EXPECT_LT((shelf.lower - Vector3(0.4, 1.5, 2.95)).norm(), 1e-12);
  EXPECT_LT((shelf.upper - Vector3(1.6, 2.5, 3.45)).norm(), 1e-12);
  EXPECT_EQ(load_scene(write_yaml(kCans)).object.name, "shelf");
  EXPECT_EQ(scene_objects(write_yaml(kCans)), (std::vector<std::string>{"shelf", "can"}));
}

// The names of the message are those of the driver; the fingers are brought inside their limits.
TEST(MoveitScene, TheRobotStandsAndStartsAsTheMessageSays) {
  const Scene scene = load_scene(write_yaml(kCans), {.choice = {.object = "can"}});
  const Carrier& carrier = scene.carrier.value();
  EXPECT_EQ(scene.hand.name, "franka_hand");
  EXPECT_EQ(carrier.X_WB.translation().z(), 0.25);
  EXPECT_LT((carrier.X_WB.linear() * Vector3::UnitX() - Vector3::UnitY()).norm(), 1e-12);
  EXPECT_EQ(carrier.start[0], 0.5);
  EXPECT_EQ(carrier.start[1], -0.7);
  EXPECT_NEAR(carrier.start[3], -2.356194, 1e-6);  // not named: as the robot's file says
  EXPECT_EQ(carrier.start.back(), 0.04);
  const auto notes_with = [&](const std::string& words) {
    int count = 0;
    for (const std::string& note : scene.notes) count += int{note.find(words) != std::string::npos};
    return count;
  };
  EXPECT_EQ(notes_with("panda_finger_joint1 starts at 0.065"), 1);
  EXPECT_EQ(notes_with("does not have: wheel"), 1);
}

TEST(MoveitScene, WithoutObjectsAnArmMayStillMove) {
  const std::filesystem::path file = write_yaml("robot_model_name: panda\nworld: {}\n");
  EXPECT_NE(refusal([&] { (void)load_scene(file); }).find("no collision object"),
            std::string::npos);
  const Scene scene = load_scene(file, {.needs_object = false});
  EXPECT_NO_THROW((void)compile(scene));
  // Of a scene file as well.
  const std::filesystem::path json = testing::TempDir() + "/moveit_no_object.json";
  std::ofstream(json) << R"({"robot": {"platform": "panda"}})";
  EXPECT_NO_THROW((void)compile(load_scene(json, {.needs_object = false})));
  EXPECT_NE(refusal([&] { (void)load_scene(json); }).find("object"), std::string::npos);
}

// With a goal of joints only: poses would need the frames of the robot's URDF.
TEST(MoveitRequest, StartAndGoalByTheNamesOfTheDriver) {
  const MotionRequest request = read_motion_request(write_yaml(R"(
start_state:
  joint_state: {name: [panda_joint1], position: [0.25]}
goal_constraints:
  - joint_constraints:
      - {joint_name: panda_joint1, position: 1.5}
      - {joint_name: panda_joint2, position: -.5}
)"));
  EXPECT_EQ(request.start, (NamedJoints{{"panda_joint1", 0.25}}));
  EXPECT_EQ(request.goal, (NamedJoints{{"panda_joint1", 1.5}, {"panda_joint2", -0.5}}));
  const auto refused = [&](const std::string& text) {
    return refusal([&] { (void)read_motion_request(write_yaml(text)); });
  };
  EXPECT_NE(refused("goal_constraints: []\n").find("no goal"), std::string::npos);
  EXPECT_NE(refused("goal_constraints: [{position_constraints: []}]\n").find("joint_constraints"),
            std::string::npos);
}

TEST(MoveitScene, RefusesWhatItCannotRead) {
  const auto refused = [&](const std::string& text) {
    return refusal([&] { (void)load_scene(write_yaml(text)); });
  };
  EXPECT_NE(refused("a: 1\n").find("not a scene of MoveIt"), std::string::npos);
  EXPECT_NE(refused("world: {collision_objects: [{id: a, planes: [1]}]}\n").find("no primitives"),
            std::string::npos);
  EXPECT_NE(refused("world: {collision_objects: [{id: a, primitives: [{type: 7}]}]}\n")
                .find("must be box, sphere"),
            std::string::npos);
  const std::string ball =
      "world: {collision_objects: [{id: a, primitives: [{type: sphere, "
      "dimensions: [0.1]}]}]}\n";
  EXPECT_NE(refused(ball).find("robot_model_name"), std::string::npos);
  EXPECT_NE(refused("robot_model_name: fanuc\n" + ball).find("fanuc"), std::string::npos);
  EXPECT_NE(refusal([&] {
              (void)load_scene(write_yaml("robot_model_name: panda\n" + ball),
                               {.choice = {.object = "b"}});
            }).find("it has a"),
            std::string::npos);
  EXPECT_NE(refusal([&] { (void)load_scene("mug", {.robot = "panda"}); }).find("MoveIt"),
            std::string::npos);
}

TEST(YamlFile, WordsWithoutQuotesAreWhatTheyLookLike) {
  const JsonFile file = parse_yaml("made.yaml", R"(
numbers: [1, -2, +3, 1e3, .5, 1.0]
words: ["1", nan, .inf, 0x, yes, 'true']
others: [true, false, ~, null]
both: &x {a: 1}
again: *x
)");
  const JsonField root = file.root();
  EXPECT_EQ(root["numbers"].numbers(6), (std::vector<double>{1, -2, 3, 1000, 0.5, 1}));
  EXPECT_EQ(root["numbers"].items()[2].integer(), 3);
  for (const JsonField& word : root["words"].items()) EXPECT_TRUE(word.is_text()) << word.name();
  EXPECT_TRUE(root["others"].items()[0].boolean());
  EXPECT_TRUE(root["others"].items()[2].is_null());
  EXPECT_EQ(root["again"]["a"].integer(), 1);
  EXPECT_EQ(refusal([] { (void)parse_yaml("made.yaml", "a: [1\nb: 2\n"); }).find("made.yaml: line"),
            0U);
}

}  // namespace
}  // namespace prehend
