#include "sim/scene/graspit_world.h"

#include <algorithm>
#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

#include "sim/robot/files/platform_file.h"
#include "sim/scene/scene_text.h"
#include "tests/support/graspit_files.h"
#include "tests/support/refusal_of.h"
#include "tests/support/shared_data.h"

namespace prehend {
namespace {

constexpr const char* kArmWorld = R"(<?xml version="1.0" ?>
<world>
  <obstacle><filename>models/obstacles/slab.xml</filename>
    <transform><fullTransform>(+1 0 0 0)[0 0 -500]</fullTransform></transform></obstacle>
  <obstacle><filename>models/obstacles/slab.xml</filename>
    <transform><fullTransform>(+1 0 0 0)[0 0 -900]</fullTransform></transform></obstacle>
  <graspableBody><filename>models/objects/brick.xml</filename>
    <transform><fullTransform>(0 0 0 +1)[+100 +200 -50]</fullTransform></transform></graspableBody>
  <graspableBody><filename>models/objects/brick.xml</filename>
    <transform><fullTransform>(+1 0 0 0)[+900 0 0]</fullTransform></transform></graspableBody>
  <robot><filename>models/robots/slider/slider.xml</filename>
    <dofValues>+100 +0.5</dofValues>
    <transform><fullTransform>(+1 0 0 0)[0 0 +1000]</fullTransform></transform></robot>
  <robot><filename>models/robots/pincher/pincher.xml</filename>
    <dofValues>+0.2 +0 +1 +0.1 +0.3</dofValues></robot>
  <connection><parentRobot>0</parentRobot><parentChain>0</parentChain><childRobot>1</childRobot>
    <mountFilename>models/robots/pincher/iv/palm.xml</mountFilename>
    <transform><fullTransform>(+1 0 0 0)[0 0 +60]</fullTransform></transform></connection>
  <camera/>
</world>
)";

constexpr const char* kFreeWorld = R"(<world>
  <graspableBody><filename>models/objects/brick.xml</filename></graspableBody>
  <robot><filename>models/robots/slider/slider.xml</filename>
    <transform><translation>0 0 2000</translation></transform></robot>
  <robot><filename>models/robots/pincher/pincher.xml</filename></robot>
</world>
)";

// A GraspIt! folder with a world in it.
std::filesystem::path written_world(const std::string& text) {
  const std::filesystem::path root = test::graspit_folder();
  test::written_graspit_hand(root);
  test::written_graspit_arm(root);
  test::write_graspit_box(root / "models/objects/brick.xml", "width 30 height 60 depth 50");
  test::write_graspit_box(root / "models/obstacles/slab.xml", "width 900 height 900 depth 20");
  test::write_graspit_text(root / "worlds/small.xml", text);
  return root / "worlds/small.xml";
}

std::string edited(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  if (at != std::string::npos) text.replace(at, from.size(), to);
  return text;
}

bool has_note(const Scene& scene, const std::string& phrase) {
  return std::any_of(scene.notes.begin(), scene.notes.end(), [&](const std::string& note) {
    return note.find(phrase) != std::string::npos;
  });
}

TEST(GraspitWorld, IsASceneWithAHandOnAnArm) {
  const std::filesystem::path file = written_world(kArmWorld);
  const Scene scene = load_scene(file);
  EXPECT_EQ(scene.name, "small");
  EXPECT_EQ(scene.object.name, "brick");
  EXPECT_EQ(scene.object.material, Material::rubber);
  EXPECT_NEAR(scene.object.mass, 0.2, 1e-12);
  EXPECT_LT((scene.object.X_WO.translation() - Vector3(0.1, 0.2, -0.05)).norm(), 1e-12);
  EXPECT_LT((scene.object.X_WO.linear() * Vector3::UnitX() + Vector3::UnitX()).norm(), 1e-12);
  ASSERT_EQ(scene.obstacles.size(), 3u);
  EXPECT_EQ(scene.obstacles[0].name, "slab");
  EXPECT_EQ(scene.obstacles[1].name, "slab_2");
  EXPECT_EQ(scene.obstacles[2].name, "brick");
  EXPECT_TRUE(has_note(scene, "brick is an obstacle: one body is grasped"));
  ASSERT_TRUE(scene.carrier.has_value());
  EXPECT_EQ(scene.carrier->hand, 1);
  EXPECT_NEAR(scene.carrier->X_WB.translation().z(), 1.0, 1e-12);
  const std::vector<double> start = {0.1, 0.5, 0.2, 0.3};
  ASSERT_EQ(scene.carrier->start.size(), start.size());
  for (std::size_t d = 0; d < start.size(); ++d) {
    EXPECT_NEAR(scene.carrier->start[d], start[d], 1e-12);
  }
  EXPECT_TRUE(has_note(scene, "start engaged again"));
}

// The mount stands 60 mm above the last frame of the arm, as the hand does.
TEST(GraspitWorld, MountsAreFixedToTheRobotThatStandsOnThem) {
  const Scene scene = load_scene(written_world(kArmWorld));
  const MountedRobot& hand = scene.carrier->platform.robots[1];
  ASSERT_TRUE(hand.mount.has_value());
  EXPECT_NEAR(bounds(hand.mount->mesh).center().z(), 0.06, 1e-9);
  EXPECT_NEAR(hand.X_MR.translation().z(), 0.06, 1e-12);
}

TEST(GraspitWorld, ReadsBackFromTheSceneFileThatIsWrittenOfIt) {
  const std::filesystem::path file = written_world(kArmWorld);
  const std::string text = scene_text(load_scene(file));
  const std::filesystem::path copy = file.parent_path() / "copy.json";
  test::write_graspit_text(copy, text);
  EXPECT_EQ(scene_text(load_scene(copy)), text);
  EXPECT_EQ(find_platform(file.string()).robots.size(), 2u);
}

TEST(GraspitWorld, HandsThatNothingCarriesFlyFree) {
  const Scene scene = load_scene(written_world(kFreeWorld));
  EXPECT_FALSE(scene.carrier.has_value());
  EXPECT_EQ(scene.hand.name, "pincher");
  EXPECT_TRUE(has_note(scene, "pincher: it flies free"));
  ASSERT_EQ(scene.obstacles.size(), 3u);
  EXPECT_EQ(scene.obstacles[0].name, "slider/palm");
  EXPECT_NEAR(
      bounds(scene.obstacles[0].mesh).center().z() + scene.obstacles[0].X_WB.translation().z(), 2.0,
      1e-9);
  EXPECT_TRUE(has_note(scene, "slider does not carry the hand"));
}

TEST(GraspitWorld, HandsHaveWhatTheFileBesideTheirsSays) {
  const std::filesystem::path file = written_world(kFreeWorld);
  test::write_graspit_text(
      file.parent_path().parent_path() / "models/robots/pincher/pincher.prehend.json",
      R"({"hand": {"approach": [0, 0, 1], "closing": [1, 0, 0], "origin": [0, 0, 0],
          "preshapes": [{"name": "open", "dofs": {}, "width": [0, 0.05], "depth": 0.03}]}})");
  const Scene scene = load_scene(file);
  ASSERT_EQ(scene.hand.hand->preshapes.size(), 1u);
  EXPECT_EQ(scene.hand.hand->preshapes[0].name, "open");
}

TEST(GraspitWorld, FilesAreFoundFromTheFolderThatGraspitNames) {
  const std::filesystem::path file = written_world(kFreeWorld);
  const std::filesystem::path root = file.parent_path().parent_path();
  const std::filesystem::path elsewhere = root.parent_path() / "GraspitWorld.elsewhere/world.xml";
  test::write_graspit_text(elsewhere, kFreeWorld);
  const std::string message = test::refusal_of([&] { (void)load_scene(elsewhere); }).what();
  EXPECT_NE(
      message.find("world.xml: line 2, <filename>: no such file in the folder of the world or "
                   "in one above it, nor in that of the environment variable GRASPIT (not "
                   "set) (models/objects/brick.xml)"),
      std::string::npos)
      << message;
  ::setenv("GRASPIT", root.c_str(), 1);
  EXPECT_EQ(load_scene(elsewhere).object.name, "brick");
  ::unsetenv("GRASPIT");
}

struct RefusedWorld {
  std::string from;
  std::string to;
  std::string phrase;
};

TEST(GraspitWorld, RefusesWithFileAndLine) {
  const std::vector<RefusedWorld> all = {
      {"+100 +0.5", "+100",
       "line 12, <dofValues>: too few values: each degree of freedom needs its own"},
      {"+100 +0.5", "+100 +0.5 1", "too many values"},
      {"+100 +0.5", "+100 x", "must be a number"},
      {"+0.2 +0 +1 +0.1 +0.3", "+0.2 +7 +1 +0.1 +0.3", "needs 0, or 1 and a value"},
      {"<parentRobot>0", "<parentRobot>2", "must be the number of a robot that is there (2)"},
      {"<parentChain>0", "<parentChain>1", "must be the number of a chain that is there (1)"},
      {"<parentRobot>0", "<parentRobot>1", "in a circle"},
      {"<world>", "<universe>", "line "},
      {"(0 0 0 +1)", "(0 0 0 0)", "not a unit quaternion"},
      {"(0 0 0 +1)", "0 0 0 +1", "must be written as (w x y z)[x y z]"},
  };
  for (const RefusedWorld& refused : all) {
    SCOPED_TRACE(refused.to);
    const auto file = written_world(edited(kArmWorld, refused.from, refused.to));
    const std::string message = test::refusal_of([&] { (void)load_scene(file); }).what();
    EXPECT_NE(message.find(refused.phrase), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
  const auto nothing = written_world("<world><camera/></world>");
  EXPECT_NE(std::string(test::refusal_of([&] { (void)load_scene(nothing); }).what())
                .find("there is no <graspableBody>"),
            std::string::npos);
  const auto no_hand =
      written_world(edited(kFreeWorld, "pincher/pincher.xml", "slider/slider.xml"));
  EXPECT_NE(std::string(test::refusal_of([&] { (void)load_scene(no_hand); }).what())
                .find("no robot here is a hand"),
            std::string::npos);
}

// An arm that calls itself a hand can be looked at, not planned with.
TEST(GraspitWorld, CanBeReadWithAHandThatCannotGrasp) {
  const std::filesystem::path file =
      written_world(edited(kFreeWorld, "pincher/pincher.xml", "slider/slider.xml"));
  const std::string three_joints =
      edited(edited(test::graspit_arm(), "</robot>",
                    "<approachDirection><referenceLocation>0 0 5</referenceLocation>"
                    "<direction>0 0 1</direction></approachDirection></robot>"),
             "<link dynamicJointType=\"Prismatic\">",
             "<joint type=\"Revolute\"><theta>d1</theta><d>0</d><a>50</a><alpha>0</alpha>"
             "<minValue>-180</minValue><maxValue>180</maxValue></joint>"
             "<link dynamicJointType=\"Revolute\">link.xml</link>"
             "<link dynamicJointType=\"Prismatic\">");
  test::write_graspit_text(file.parent_path().parent_path() / "models/robots/slider/slider.xml",
                           three_joints);
  EXPECT_NE(std::string(test::refusal_of([&] { (void)load_scene(file); }).what())
                .find("nothing that could grasp"),
            std::string::npos);
  const Scene scene = load_scene(file, {.hand = "", .derive_hand = false});
  EXPECT_EQ(scene.hand.name, "slider");
  EXPECT_TRUE(scene.hand.hand->preshapes.empty());
}

TEST(GraspitBodyFile, IsTheObjectOfAScene) {
  const std::filesystem::path file = written_world(kFreeWorld);
  const Scene scene = load_scene(file.parent_path().parent_path() / "models/objects/brick.xml",
                                 {.hand = "barrett"});
  EXPECT_EQ(scene.object.name, "brick");
  EXPECT_EQ(scene.hand.name, "barrett");
}

TEST(GraspitWorld, SaysWhatTheSharedWorldsLack) {
  PREHEND_NEEDS_SHARED("data/robots/graspit/worlds");
  const auto refusal = [](const std::string& world) {
    const auto file = test::shared("data/robots/graspit/worlds") / (world + ".xml");
    return std::string(test::refusal_of([&] { (void)load_scene(file); }).what());
  };
  EXPECT_NE(refusal("plannerMug").find("(models/objects/mug.xml)"), std::string::npos);
  EXPECT_NE(refusal("cvap").find("there is no <graspableBody>"), std::string::npos);
  EXPECT_NE(refusal("barrettGlassDyn").find("(models/objects/glass.xml)"), std::string::npos);
}

}  // namespace
}  // namespace prehend
