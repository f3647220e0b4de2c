// Sessions: motions that end at contact, grasps that equal those of evaluate, undo of everything.
#include "planner/live/session.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "planner/live/state_memory.h"
#include "planner/results/grasps_file.h"
#include "sim/base/json/json_field.h"
#include "sim/base/random.h"
#include "sim/scene/make_scene.h"
#include "sim/scene/scene_file.h"
#include "sim/scene/scene_text.h"
#include "tests/support/refusal_of.h"
#include "tests/support/scenes.h"

namespace prehend::test {
namespace {

// A ball of radius 30 mm at the origin and a parallel jaw above it.
Session ball_session() {
  Session session;
  session.set_scene(scene_of_hand("parallel_jaw"));
  session.edit([](Scene& scene) {
    set_object(scene, surface_of({.generate = "ball", .triangles = 800}, {}), {.name = "ball"});
  });
  return session;
}

const CompiledScene& compiled_of(const Session& session) {
  return session.state().world->compiled();
}

double smallest_gap(const Session& session) {
  const std::vector<double> gaps =
      object_gaps(compiled_of(session), session.state().hand.X_OH, session.state().hand.joints);
  return *std::min_element(gaps.begin(), gaps.end());
}

// Contacts are within 0.1 mm.
constexpr double kContact = 1e-4;

TEST(Session, PrimitivesAreLookedForWhereTheSurfaceIsAnotherOne) {
  Session session = ball_session();
  const Primitive* first = session.primitives().all.data();
  EXPECT_EQ(session.primitives().all.data(), first);
  session.set_switches({.stop_at_contact = false});
  session.move_object(translation({0.1, 0.2, 0.3}));
  EXPECT_EQ(session.primitives().all.data(), first);
  EXPECT_EQ(shape_name(first->shape), "sphere");
  session.edit([](Scene& scene) {
    set_object(scene, surface_of({.generate = "box", .triangles = 12}, {}), {.name = "box"});
  });
  EXPECT_EQ(shape_name(session.primitives().all.front().shape), "box");
}

TEST(Session, DraggedHandsStopAtTheObjectFromAllSides) {
  Session session = ball_session();
  Random random(3);
  int touched = 0;
  for (int i = 0; i < 30; ++i) {
    // From a free pose through the object's middle, turning on the way.
    session.set_switches({.stop_at_contact = false});
    const Vector3 from = 0.4 * random.direction();
    session.move_hand(pose_from(random.rotation(), from));
    session.set_switches({.stop_at_contact = true});
    const HandMotion motion = session.move_hand(pose_from(random.rotation(), -from));
    ASSERT_NE(motion.end, MotionEnd::starts_in_collision);
    EXPECT_EQ(
        collision(compiled_of(session), session.state().hand.X_OH, session.state().hand.joints),
        "");
    if (motion.end != MotionEnd::touched) continue;
    ++touched;
    EXPECT_GT(motion.share, 0.0);
    EXPECT_LT(motion.share, 1.0);
    EXPECT_EQ(motion.by, "ball");
    EXPECT_LE(smallest_gap(session), kContact);
    EXPECT_GT(smallest_gap(session), 0.0);
  }
  EXPECT_GT(touched, 20);
}

TEST(Session, AHandThatTouchesMovesAwayAndNoFartherIn) {
  Session session = ball_session();
  ASSERT_EQ(session.approach(0.5).end, MotionEnd::touched);
  const Pose there = session.state().hand.X_OH;
  for (int i = 0; i < 10; ++i) {
    const Pose in = session.state().hand.X_OH *
                    translation(0.01 * compiled_of(session).scene.hand.hand->approach);
    EXPECT_EQ(session.move_hand(in).end, MotionEnd::touched);
    EXPECT_GT(smallest_gap(session), 0.0);
  }
  EXPECT_LT((session.state().hand.X_OH.translation() - there.translation()).norm(), kContact);
  EXPECT_EQ(session.back_off(0.05).end, MotionEnd::arrived);
  EXPECT_NEAR((session.state().hand.X_OH.translation() - there.translation()).norm(), 0.05,
              kContact);
}

TEST(Session, WithoutTheSwitchHandsGoThroughWhatIsThere) {
  Session session = ball_session();
  session.set_switches({.stop_at_contact = false});
  EXPECT_EQ(session.move_hand(Pose::Identity()).end, MotionEnd::arrived);
  EXPECT_FALSE(session.collisions().empty());
  // Back with the switch, a hand that overlaps something stays.
  session.set_switches({.stop_at_contact = true});
  EXPECT_EQ(session.move_hand(translation({0, 0, 1})).end, MotionEnd::starts_in_collision);
  EXPECT_EQ(session.state().hand.X_OH.matrix(), Pose::Identity().matrix());
}

TEST(Session, ApproachesThatMissLeaveTheHandAndTheHistory) {
  Session session = ball_session();
  const std::size_t before = session.undo_count();
  EXPECT_EQ(session.approach(0.01).share, 0.0);
  EXPECT_EQ(session.undo_count(), before);
}

TEST(Session, JointsEndAtTheirLimitsAndCoupledOnesFollow) {
  Session session;
  session.set_scene(scene_of_hand("barrett"));
  const Robot& hand = session.state().world->scene().hand;
  std::vector<double> upper;
  std::vector<double> lower;
  for (const DegreeOfFreedom& dof : hand.dofs) {
    upper.push_back(dof.upper);
    lower.push_back(dof.lower);
  }
  session.set_dofs(std::vector<double>(upper.size(), 100.0));
  EXPECT_EQ(session.state().hand.dofs, upper);
  EXPECT_EQ(session.state().hand.joints, joint_values(hand, upper));
  session.set_dofs(std::vector<double>(upper.size(), -100.0));
  EXPECT_EQ(session.state().hand.dofs, lower);
  EXPECT_EQ(session.state().hand.joints, joint_values(hand, lower));
  EXPECT_EQ(refusal_of([&] { session.set_dofs({0.0}); }).field(), "dofs");
}

// The epsilon that evaluate gives for the posture. The pose goes through a quaternion, as in files.
double evaluated(const Session& session, const HandPosture& posture) {
  Candidate candidate;
  candidate.X_OH = pose_from(quaternion_of(posture.X_OH).normalized().toRotationMatrix(),
                             posture.X_OH.translation());
  candidate.dofs = posture.dofs;
  candidate.joints = posture.joints;
  candidate.approach_O = posture.X_OH.linear() * session.state().world->scene().hand.hand->approach;
  return evaluate(compiled_of(session), {candidate}).grasps.at(0).trial.epsilon.lower;
}

TEST(Session, EpsilonIsThatOfEvaluate) {
  for (const char* hand : {"barrett", "parallel_jaw"}) {
    Session session;
    session.set_scene(scene_of_hand(hand));
    session.edit([](Scene& scene) {
      set_object(scene, surface_of({.generate = "cylinder", .triangles = 600}, {}), {});
    });
    session.approach(0.5);
    session.back_off(0.005);
    const HandPosture before = session.state().hand;
    const Trial trial = session.auto_grasp();
    EXPECT_EQ(trial.outcome, Outcome::stable) << hand;
    const double epsilon = session.quality().epsilon.lower;
    EXPECT_GT(epsilon, 0.0);
    EXPECT_NEAR(trial.epsilon.lower, epsilon, 1e-9);
    EXPECT_NEAR(evaluated(session, before), epsilon, 1e-9) << "from the open hand";
    EXPECT_NEAR(evaluated(session, session.state().hand), epsilon, 1e-9) << "from the closed one";
    EXPECT_EQ(
        collision(compiled_of(session), session.state().hand.X_OH, session.state().hand.joints),
        "");
  }
}

// Compiled scenes are large; what shares one is not.
// A scene with a ball of so many triangles, whose mass was changed so many times; after each change
// the hand was moved.
Session changed_session(std::size_t undo_memory, int changes) {
  Session session({.undo_memory = undo_memory});
  session.set_scene(scene_of_hand("parallel_jaw"));
  session.edit([](Scene& scene) {
    set_object(scene, surface_of({.generate = "ball", .triangles = 2000}, {}), {});
  });
  session.forget_history();
  for (int k = 0; k < changes; ++k) {
    const double mass = 0.1 + 0.01 * k;
    session.edit([&](Scene& scene) { change_object(scene, {.mass = mass}); });
    session.back_off(0.001);
  }
  return session;
}

TEST(Session, UndoKeepsTheNewestStatesThatFitIntoItsMemory) {
  constexpr int kChanges = 12;
  // Of one of the scenes, which differ in a number only.
  StateMemory one;
  one.add(changed_session(0, 1).state().world.get());
  EXPECT_GT(one.bytes(), 2000 * 300U);
  for (const int scenes : {0, 1, 2, 5, kChanges - 1, kChanges + 5}) {
    const std::size_t room = static_cast<std::size_t>(scenes) * one.bytes() + one.bytes() / 2;
    Session session = changed_session(room, kChanges);
    // One state shares the present scene, which costs nothing; two are of each scene before that,
    // one of the first.
    const auto states = static_cast<std::size_t>(std::min(1 + 2 * scenes, 2 * kChanges));
    EXPECT_EQ(session.undo_count(), states) << scenes;
    // All that undo leads back to fits together.
    StateMemory memory;
    memory.add(session.state().world.get());
    const std::size_t present = memory.bytes();
    std::vector<EditedScenePtr> worlds;
    while (session.undo()) {
      worlds.push_back(session.state().world);
      memory.add(worlds.back().get());
    }
    EXPECT_LE(memory.bytes() - present, room);
    EXPECT_EQ(session.redo_count(), states);
  }
}

TEST(Session, WhatStatesShareIsCountedOnce) {
  Session session({.undo_memory = 0});
  session.set_scene(load_scene("mug_on_table"));
  // Motions of bodies and hands make no new scene, so that undo needs no memory for them.
  session.forget_history();
  for (int k = 0; k < 10; ++k) session.back_off(0.001);
  EXPECT_EQ(session.undo_count(), 10U);
  StateMemory memory;
  memory.add(session.state().world.get());
  const std::size_t once = memory.bytes();
  memory.add(session.state().world.get());
  EXPECT_EQ(memory.bytes(), once);
  // The same bodies elsewhere: the trees are shared, the meshes of the scene are not.
  const EditedScenePtr moved =
      with_bodies_at(session.state().world, places_of(session.state().world->scene()));
  memory.add(moved.get());
  EXPECT_GT(memory.bytes(), once);
  EXPECT_LT(memory.bytes() - once, once / 2);
  StateMemory other;
  other.add(moved.get());
  EXPECT_EQ(other.bytes(), memory.bytes());
  // It grows with what is there.
  session.edit([](Scene& scene) {
    add_obstacle(scene, surface_of({.generate = "ball"}, {}),
                 {.name = "b", .X_WB = translation({0.0, 0.0, 2.0})});
  });
  StateMemory larger;
  larger.add(session.state().world.get());
  EXPECT_GT(larger.bytes(), once);
}

TEST(Session, ForcesBalanceTheLoad) {
  Session session = ball_session();
  session.approach(0.5);
  session.auto_grasp();
  ASSERT_EQ(session.quality().outcome, Outcome::stable);
  const Vector3 load(1.0, -2.0, -3.0);
  const ContactForces forces = session.forces(load, Vector3::Zero(), false);
  ASSERT_EQ(forces.outcome, ForceOutcome::balanced);
  // The forces add up to what the load takes.
  EXPECT_LT((forces.forces.rowwise().sum() + load).norm(), 1e-6 * load.norm());
  EXPECT_FALSE(session.quality().limiting_link.empty());
  EXPECT_LT(session.quality().epsilon_without, session.quality().epsilon.lower);
}

// A tetrahedron with edges along the axes, 40 long.
constexpr const char* kTetrahedron =
    "v 0 0 0\nv 40 0 0\nv 0 40 0\nv 0 0 40\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

TEST(Session, MeshesThatAreGivenAsTextAreKeptInTheSceneFile) {
  const BodySurface surface = surface_of({.mesh_text = kTetrahedron, .format = "obj"}, {});
  EXPECT_NEAR(bounds(surface.mesh).size().x(), 0.04, 1e-9) << "read in mm";
  const BodySurface metres =
      surface_of({.mesh_text = kTetrahedron, .format = "obj", .unit = "m"}, {});
  EXPECT_NEAR(bounds(metres.mesh).size().x(), 40.0, 1e-6);
  Session session;
  session.edit([&](Scene& scene) { set_object(scene, surface, {.name = "wedge", .mass = 0.2}); });
  const std::string text = scene_text(session.state().world->scene());
  session.set_scene(scene_of_text(text, {}));
  EXPECT_EQ(scene_text(session.state().world->scene()), text);
  EXPECT_EQ(session.state().world->scene().object.mass, 0.2);
  const InputError unknown =
      refusal_of([] { (void)surface_of({.mesh_text = kTetrahedron, .format = "gltf"}, {}); });
  EXPECT_EQ(unknown.field(), "format");
}

TEST(Session, ScenesThatAreSavedAndLoadedKeepTheirBytes) {
  for (const char* name : {"mug", "mug_on_table"}) {
    Session session;
    session.set_scene(open_scene(name, {}));
    const std::string text = scene_text(session.state().world->scene());
    session.set_scene(scene_of_text(text, OpenFolders()));
    EXPECT_EQ(scene_text(session.state().world->scene()), text) << name;
  }
}

TEST(Session, UndoLeadsBackToTheSameBytesAndRedoForward) {
  Session session;
  session.set_scene(load_scene("mug"));
  const std::string start = scene_text(session.state().world->scene());
  EXPECT_EQ(start, scene_text(load_scene("mug")));
  const std::size_t begun = session.undo_count();
  session.edit([](Scene& scene) { change_object(scene, {.mass = 0.5}); });
  session.edit([](Scene& scene) {
    add_obstacle(scene, surface_of({.generate = "box"}, {}),
                 {.name = "box", .X_WB = translation({0.5, 0, 0})});
  });
  session.edit([](Scene& scene) { change_obstacle(scene, "box", {.name = "crate"}); });
  session.edit([](Scene& scene) { change_object(scene, {.material = Material::glass}); });
  session.edit([](Scene& scene) { choose_hand(scene, "parallel_jaw"); });
  session.edit([](Scene& scene) { remove_obstacle(scene, "crate"); });
  const std::string end = scene_text(session.state().world->scene());
  EXPECT_NE(start, end);
  while (session.undo_count() > begun) EXPECT_TRUE(session.undo());
  EXPECT_EQ(scene_text(session.state().world->scene()), start);
  while (session.redo_count() > 0) EXPECT_TRUE(session.redo());
  EXPECT_EQ(scene_text(session.state().world->scene()), end);
  EXPECT_FALSE(session.redo());
}

TEST(Session, TheHandStaysInTheWorldWhenTheObjectMoves) {
  Session session = ball_session();
  const Pose before = session.X_WH();
  const Pose moved = pose_from(Random(5).rotation(), Vector3(0.1, 0.2, 0.3));
  session.edit([&](Scene& scene) { change_object(scene, {.X_WB = moved}); });
  EXPECT_TRUE(session.X_WH().isApprox(before, 1e-12));
}

TEST(Session, RefusedEditsChangeNothing) {
  Session session = ball_session();
  const std::uint64_t revision = session.revision();
  EXPECT_EQ(refusal_of([&] {
              session.edit([](Scene& scene) { remove_obstacle(scene, "wall"); });
            }).field(),
            "name");
  EXPECT_EQ(refusal_of([&] {
              session.edit([](Scene& scene) { change_object(scene, {.mass = -1.0}); });
            }).field(),
            "mass");
  EXPECT_EQ(refusal_of([&] { session.take_preshape("none"); }).field(), "preshape");
  EXPECT_EQ(refusal_of([&] { session.go_to(0); }).field(), "grasp");
  EXPECT_EQ(session.revision(), revision);
}

TEST(Session, ScenesThatCannotBeUsedSayWhyAndAreEditedOn) {
  Session session = ball_session();
  session.edit([](Scene& scene) {
    add_obstacle(scene, surface_of({.generate = "ball"}, {}), {.name = "inside"});
  });
  EXPECT_FALSE(session.state().world->is_ready());
  EXPECT_NE(session.state().world->problem(), "");
  EXPECT_EQ(refusal_of([&] { session.auto_grasp(); }).field(), "scene");
  session.edit([](Scene& scene) { remove_obstacle(scene, "inside"); });
  EXPECT_TRUE(session.state().world->is_ready());
}

TEST(Session, FilesOutsideOfOpenFoldersAreNotNamed) {
  const std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) / "prehend_open_folder";
  std::filesystem::create_directories(folder / "inner");
  const OpenFolders open({folder});
  EXPECT_EQ(open.path_of("inner/a.json", "file"),
            std::filesystem::canonical(folder) / "inner" / "a.json");
  for (const char* name : {"../a.json", "/etc/passwd", "inner/../../a.json", "."}) {
    EXPECT_EQ(refusal_of([&] { (void)open.path_of(name, "file"); }).field(), "file") << name;
  }
  EXPECT_EQ(open.robot_of("barrett", "hand"), "barrett");
  // As all files, whether the name has a folder in it or not.
  for (const char* name : {"x.json", "./x.json", "x.urdf"}) {
    EXPECT_EQ(open.robot_of(name, "hand"),
              (std::filesystem::canonical(folder) / name).lexically_normal())
        << name;
  }
  std::ofstream(folder / "plain_name") << "{}";
  EXPECT_EQ(open.robot_of("plain_name", "hand"), std::filesystem::canonical(folder) / "plain_name");
  EXPECT_EQ(refusal_of([&] { (void)OpenFolders().robot_of("x.json", "hand"); }).field(), "hand");
  EXPECT_EQ(refusal_of([&] { (void)open.robot_of("/etc/passwd", "hand"); }).field(), "hand");
  EXPECT_EQ(refusal_of([&] { (void)OpenFolders().path_of("a", "file"); }).field(), "file");
  const InputError mesh =
      refusal_of([&] { (void)scene_of_text(R"({"object": {"mesh": "/etc/passwd"}})", open); });
  EXPECT_NE(std::string(mesh.what()).find("not in a folder that is open"), std::string::npos);
}

// The robot of a scene stands beside it, in the library or where the program was started, and is
// not read there unless that is open.
TEST(Session, ScenesNameNoRobotsOfTheWorkingFolder) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "prehend_beside";
  const std::filesystem::path elsewhere = folder / "elsewhere";
  std::filesystem::create_directories(elsewhere);
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(elsewhere);
  std::ofstream(elsewhere / "secret.json") << "not a robot";
  std::filesystem::create_directories(folder / "open");
  const OpenFolders open({folder / "open"});
  const std::string text = R"({"object": {"mesh": "secret.json"}, "hand": "secret.json"})";
  const InputError error = refusal_of([&] { (void)scene_of_text(text, open); });
  std::filesystem::current_path(before);
  EXPECT_NE(std::string(error.what()).find("not in a folder that is open"), std::string::npos)
      << error.what();
}

TEST(Session, NamesWithControlCharactersAreRefused) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "prehend_nul";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "pear.obj") << kTetrahedron;
  const OpenFolders open({folder});
  EXPECT_NO_THROW((void)surface_of({.mesh = "pear.obj"}, open));
  for (const std::string& name :
       {std::string("pear.obj\0.obj", 13), std::string("pear.obj\0", 9), std::string("a\nb.obj")}) {
    EXPECT_EQ(refusal_of([&] { (void)surface_of({.mesh = name}, open); }).field(), "mesh");
    EXPECT_EQ(refusal_of([&] { (void)open_scene(name, open); }).field(), "scene");
    EXPECT_EQ(refusal_of([&] { (void)open.robot_of(name, "hand"); }).field(), "hand");
    const std::string quoted = nlohmann::json(name).dump();
    for (const std::string& text :
         {R"({"object": {"mesh": )" + quoted + "}}",
          R"({"object": {"generate": "ball"}, "hand": )" + quoted + "}"}) {
      EXPECT_EQ(refusal_of([&] { (void)scene_of_text(text, open); }).field(), "text") << text;
    }
  }
}

}  // namespace
}  // namespace prehend::test
