// Objects and obstacles that are dragged: they end at contact, and undo leads back.
#include "planner/live/body_motion.h"

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "planner/live/session.h"
#include "sim/base/json/json_field.h"
#include "sim/base/random.h"
#include "sim/scene/scene_file.h"
#include "sim/scene/scene_text.h"
#include "tests/support/refusal_of.h"
#include "tests/support/scenes.h"

namespace prehend::test {
namespace {

constexpr double kTouching = 1e-4;  // m

// A box in front of a parallel jaw that is 0.4 m above, and a post beside it.
Session box_session() {
  Session session;
  session.set_scene(scene_of_hand("parallel_jaw"));
  session.edit([](Scene& scene) {
    set_object(scene, surface_of({.generate = "box", .triangles = 300}, {}), {.name = "box"});
    add_obstacle(scene, surface_of({.generate = "cylinder", .triangles = 300}, {}),
                 {.name = "post", .X_WB = translation({0.5, 0.0, 0.0})});
  });
  session.set_switches({.stop_at_contact = false});
  session.move_hand(translation({0.0, 0.0, 0.4}));
  session.set_switches({.stop_at_contact = true});
  return session;
}

const CompiledScene& scene_of(const Session& session) { return session.state().world->compiled(); }

double gap_to_hand(const Session& session) {
  const std::vector<double> gaps =
      object_gaps(scene_of(session), session.state().hand.X_OH, session.state().hand.joints);
  return *std::min_element(gaps.begin(), gaps.end());
}

double gap_to_post(const Session& session) {
  const CompiledScene& scene = scene_of(session);
  return surface_gap(soup(scene.object().mesh.mesh()),
                     soup(scene.obstacles()[0].mesh.mesh(), scene.obstacles()[0].X_RB));
}

void expect_free(const Session& session) {
  ASSERT_TRUE(session.state().world->is_ready()) << session.state().world->problem();
  EXPECT_EQ(collision(scene_of(session), session.state().hand.X_OH, session.state().hand.joints),
            "");
}

TEST(BodyMotion, TheObjectEndsAtTheHandFromAllSides) {
  Session session = box_session();
  Random random(7);
  int touched = 0;
  for (int i = 0; i < 25; ++i) {
    session.set_switches({.stop_at_contact = false});
    const Pose X_WH = session.X_WH();
    const Vector3 from = 0.4 * random.direction();
    session.move_object(pose_from(random.rotation(), X_WH.translation() + from));
    session.set_switches({.stop_at_contact = true});
    const BodyMotion motion =
        session.move_object(pose_from(random.rotation(), X_WH.translation() - from));
    ASSERT_NE(motion.end, MotionEnd::starts_in_collision) << motion.touches;
    EXPECT_TRUE(session.X_WH().isApprox(X_WH, 1e-12)) << "the hand stays";
    EXPECT_TRUE(session.state().world->X_WO().isApprox(motion.X_WB, 1e-12));
    expect_free(session);
    if (motion.end != MotionEnd::touched || motion.touches == "post") continue;
    ++touched;
    EXPECT_LE(gap_to_hand(session), kTouching);
    EXPECT_GT(gap_to_hand(session), 0.0);
    EXPECT_LT(motion.share, 1.0);
  }
  EXPECT_GT(touched, 15);
}

TEST(BodyMotion, ObstaclesEndAtTheObjectAndTheObjectAtObstacles) {
  Session session = box_session();
  const BodyMotion to_post = session.move_object(translation({0.6, 0.0, 0.0}));
  EXPECT_EQ(to_post.end, MotionEnd::touched);
  EXPECT_EQ(to_post.touches, "post");
  EXPECT_LE(gap_to_post(session), kTouching);
  EXPECT_GT(gap_to_post(session), 0.0);
  EXPECT_TRUE(session.undo());
  const BodyMotion post = session.move_obstacle("post", translation({-0.5, 0.0, 0.0}));
  EXPECT_EQ(post.end, MotionEnd::touched);
  EXPECT_EQ(post.touches, "box");
  EXPECT_LE(gap_to_post(session), kTouching);
  EXPECT_GT(gap_to_post(session), 0.0);
  EXPECT_EQ(refusal_of([&] { session.move_obstacle("wall", Pose::Identity()); }).field(), "name");
}

TEST(BodyMotion, WhatIsPushedOnAndOnNeverPenetratesAndStillSlidesAndLeaves) {
  Session session = box_session();
  for (int i = 0; i < 200; ++i) {
    const BodyMotion motion = session.move_object(translation({0.6, 0.0, 0.0}), 1);
    ASSERT_EQ(motion.end, MotionEnd::touched) << i;
    ASSERT_TRUE(session.state().world->is_ready()) << i;
  }
  EXPECT_GT(gap_to_post(session), 1e-7);
  EXPECT_LE(gap_to_post(session), kTouching);
  const Vector3 at = session.state().world->X_WO().translation();
  EXPECT_EQ(session.move_object(translation(at - Vector3(0.1, 0.0, 0.0))).end, MotionEnd::arrived);
}

TEST(BodyMotion, ABodySlidesAllTheWayAlongWhatItNearlyTouches) {
  Session session;
  session.set_scene(scene_of_hand("parallel_jaw"));
  session.edit([](Scene& scene) {
    set_object(scene, surface_of({.generate = "mug", .triangles = 3000}, {}), {.name = "mug"});
    StaticBody table = obstacle(block({2.0, 2.0, 0.04}, Vector3::Zero()), Vector3::Zero());
    const double bottom = bounds(scene.object.mesh).lower.z();
    table.X_WB = translation({0.0, 0.0, bottom - 0.02 - 3e-5});
    scene.obstacles.push_back(table);
  });
  ASSERT_TRUE(session.state().world->is_ready());
  for (const double x : {0.5, -0.5, 0.0}) {
    const BodyMotion motion = session.move_object(translation({x, 0.1, 0.0}));
    EXPECT_EQ(motion.end, MotionEnd::arrived) << motion.share << " " << motion.touches;
  }
  // It turns on the table as it slides.
  for (const double angle : {2.0, -2.0}) {
    const Pose turned(translation({0.4 * angle, 0.0, 0.0}) *
                      Eigen::AngleAxisd(angle, Vector3::UnitZ()));
    EXPECT_EQ(session.move_object(turned).end, MotionEnd::arrived);
  }
  session.move_object(translation({0.0, 0.1, 0.0}));
  const BodyMotion down = session.move_object(translation({0.0, 0.1, -0.1}));
  EXPECT_EQ(down.end, MotionEnd::touched);
  EXPECT_TRUE(session.state().world->is_ready());
}

TEST(BodyMotion, WithoutTheSwitchBodiesGoThroughAndTheStateSaysSo) {
  Session session = box_session();
  session.set_switches({.stop_at_contact = false});
  EXPECT_EQ(session.move_object(translation({0.5, 0.0, 0.0})).end, MotionEnd::arrived);
  EXPECT_FALSE(session.state().world->is_ready());
  session.set_switches({.stop_at_contact = true});
  EXPECT_EQ(session.move_object(Pose::Identity()).end, MotionEnd::starts_in_collision);
  session.set_switches({.stop_at_contact = false});
  session.move_object(Pose::Identity());
  EXPECT_TRUE(session.state().world->is_ready());
}

TEST(BodyMotion, ADragIsOneStepAndUndoAndRedoGiveTheSameBytes) {
  Session session = box_session();
  const std::string before = scene_text(session.state().world->scene());
  const Pose hand = session.state().hand.X_OH;
  const std::size_t steps = session.undo_count();
  for (int i = 1; i <= 50; ++i) session.move_object(translation({0.0, 0.002 * i, 0.0}), 4);
  EXPECT_EQ(session.undo_count(), steps + 1);
  for (int i = 1; i <= 50; ++i) {
    session.move_obstacle("post", translation({0.5, 0.0, 0.002 * i}), 4);
  }
  EXPECT_EQ(session.undo_count(), steps + 2) << "another body is another drag";
  session.move_object(translation({0.0, 0.2, 0.0}), 4);
  EXPECT_EQ(session.undo_count(), steps + 3) << "what follows something else is another drag";
  const std::string after = scene_text(session.state().world->scene());
  const Pose hand_after = session.state().hand.X_OH;
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(session.undo());
  EXPECT_EQ(scene_text(session.state().world->scene()), before);
  EXPECT_EQ(session.state().hand.X_OH.matrix(), hand.matrix());
  EXPECT_TRUE(session.state().world->is_ready());
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(session.redo());
  EXPECT_EQ(scene_text(session.state().world->scene()), after);
  EXPECT_EQ(session.state().hand.X_OH.matrix(), hand_after.matrix());
  session.undo();
  session.move_object(translation({0.0, 0.3, 0.0}), 4);
  EXPECT_EQ(session.undo_count(), steps + 3) << "after undo it is a new step";
  for (int i = 0; i < 20; ++i) session.move_hand(translation({0.0, 0.01 * i, 0.4}), 5);
  EXPECT_EQ(session.undo_count(), steps + 4);
}

TEST(BodyMotion, MovedScenesAreThoseThatAreCompiledThere) {
  for (const char* name : {"mug", "mug_on_table", "panda_on_table"}) {
    const CompiledScene scene = compile(load_scene(name));
    BodyPlaces places = places_of(scene.scene);
    places.X_WO = translation({0.03, -0.02, 0.05}) * places.X_WO;
    if (!places.X_WB.empty()) places.X_WB.back() = translation({0.0, 0.02, 0.0}) * places.X_WB[0];
    Scene moved = scene.scene;
    set_places(moved, places);
    CompiledScene anew = compile(moved);
    const CompiledScene quick = with_bodies_at(scene, places);
    EXPECT_EQ(scene_text(quick.scene), scene_text(anew.scene)) << name;
    for (std::size_t b = 0; b < anew.bodies.size(); ++b) {
      EXPECT_EQ(quick.bodies[b].X_RB.matrix(), anew.bodies[b].X_RB.matrix()) << name << b;
    }
    ASSERT_EQ(quick.arm.has_value(), anew.arm.has_value());
    if (!quick.arm) continue;
    EXPECT_EQ(quick.arm->X_BO.matrix(), anew.arm->X_BO.matrix());
    ASSERT_EQ(quick.arm->arm_pairs.size(), anew.arm->arm_pairs.size()) << name;
    for (std::size_t i = 0; i < anew.arm->arm_pairs.size(); ++i) {
      EXPECT_EQ(quick.arm->arm_pairs[i].link, anew.arm->arm_pairs[i].link) << i;
      EXPECT_EQ(quick.arm->arm_pairs[i].other, anew.arm->arm_pairs[i].other) << i;
    }
  }
}

TEST(BodyMotion, AnObjectThatIsRemovedLeavesHandAndObstacles) {
  Session session = box_session();
  const Pose X_WH = session.X_WH();
  session.edit([](Scene& scene) { remove_object(scene); });
  EXPECT_FALSE(session.state().world->has_object());
  EXPECT_TRUE(session.X_WH().isApprox(X_WH, 1e-12));
  EXPECT_EQ(session.state().world->scene().obstacles.size(), 1U);
  EXPECT_EQ(refusal_of([&] { session.move_object(Pose::Identity()); }).field(), "object");
  EXPECT_EQ(session.move_obstacle("post", Pose::Identity()).end, MotionEnd::arrived);
  EXPECT_TRUE(session.undo());
  EXPECT_TRUE(session.undo());
  EXPECT_TRUE(session.state().world->is_ready());
}

}  // namespace
}  // namespace prehend::test
