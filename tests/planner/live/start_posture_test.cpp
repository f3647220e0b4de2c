// Where hands stand when a scene is opened.
#include "planner/live/start_posture.h"

#include <gtest/gtest.h>

#include "planner/live/session.h"
#include "sim/scene/make_scene.h"
#include "sim/scene/scene_file.h"
#include "sim/scene/scene_library.h"
#include "tests/support/scenes.h"

namespace prehend::test {
namespace {

TEST(StartPosture, EveryLibrarySceneOpensFreeOfCollisionsAndPlays) {
  for (const std::string& name : library_scene_names()) {
    SCOPED_TRACE(name);
    Session session;
    session.set_scene(load_scene(name));
    for (const Overlap& overlap : session.collisions()) {
      ADD_FAILURE() << overlap.link << " in " << overlap.by;
    }
    if (session.state().arm) {
      EXPECT_TRUE(session.state().arm->reached()) << session.state().arm->problem;
    }
    session.start_time({});
    session.moving().advance(0.01);
    session.stop_time(false);
  }
}

// What opens is also the beginning of a grasp.
TEST(StartPosture, TheHandPointsAtTheObject) {
  for (const std::string& name : library_scene_names()) {
    SCOPED_TRACE(name);
    Session session;
    session.set_scene(load_scene(name));
    const HandMotion motion = session.approach(0.5);
    EXPECT_EQ(motion.end, MotionEnd::touched);
    EXPECT_EQ(motion.by, session.state().world->scene().object.name);
  }
}

// A plate of 200 mm that stands on its edge: above it as the world has it, not along its axis.
TEST(StartPosture, IsAboveTheObjectAsItLiesInTheWorld) {
  Scene scene = scene_of_hand("parallel_jaw");
  set_object(scene, {make_box({0.2, 0.1, 0.02}), {}, "plate"}, {.name = "plate"});
  scene.object.X_WO = pose_from(
      Eigen::AngleAxisd(0.5 * std::numbers::pi, Vector3::UnitY()).toRotationMatrix(), {1.0, 2, 3});
  const Hand hand = *scene.hand.hand;
  const EditedScene world(std::move(scene));
  const HandPosture posture = start_posture(world, {});
  const Pose X_WH = world.X_WO() * posture.X_OH;
  EXPECT_LT((X_WH.linear() * hand.approach + Vector3::UnitZ()).norm(), 1e-12);
  EXPECT_LT((X_WH * hand.origin - Vector3(1.0, 2.0, 3.0 + 0.1 + 0.1)).norm(), 1e-12);
}

// Between the object and a board above it there is no place.
TEST(StartPosture, IsAtASideWhereSomethingIsAbove) {
  Scene scene = scene_of_hand("parallel_jaw");
  set_object(scene, {make_box({0.04, 0.04, 0.04}), {}, "cube"}, {.name = "cube"});
  const auto board = [&](const char* name, double z) {
    add_obstacle(scene, {make_box({1.0, 1.0, 0.02}), {}, name},
                 {.name = name, .X_WB = translation({0.0, 0.0, z})});
  };
  board("upper", 0.1);
  board("lower", -0.1);
  const Hand hand = *scene.hand.hand;
  const EditedScene world(std::move(scene));
  ASSERT_TRUE(world.is_ready()) << world.problem();
  const HandPosture posture = start_posture(world, {});
  EXPECT_TRUE(overlaps_of(world.compiled(), posture.X_OH, posture.joints).empty());
  EXPECT_LT(std::abs((posture.X_OH.linear() * hand.approach).z()), 1e-12);
}

}  // namespace
}  // namespace prehend::test
