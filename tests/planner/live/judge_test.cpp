// Grasps judged in a session by other norms and pyramids, and with other friction.
#include <gtest/gtest.h>

#include "planner/live/session.h"
#include "sim/quality/set_hull.h"
#include "sim/scene/scene_file.h"
#include "sim/scene/scene_text.h"
#include "sim/trial/grasp_contacts.h"
#include "tests/support/refusal_of.h"
#include "tests/support/scenes.h"

namespace prehend::test {
namespace {

// Three fingers that hold the mug.
Session held_mug() {
  Session session;
  session.set_scene(load_scene("mug"));
  session.approach(0.5);
  EXPECT_EQ(session.auto_grasp().outcome, Outcome::stable);
  return session;
}

std::vector<Contact> points_of(const Session& session) { return contacts_of(session.contacts()); }

const WrenchFrame& frame_of(const Session& session) {
  return session.state().world->compiled().wrench_frame;
}

TEST(Judge, EpsilonIsThatOfTheNormAndThePyramids) {
  Session session = held_mug();
  for (const WrenchNorm norm : kAll<WrenchNorm>) {
    for (const int edges : {6, 8, 20}) {
      session.set_judge({.norm = norm, .edges = edges});
      const GraspScore score = session.quality();
      const EpsilonBracket expected =
          grasp_epsilon(points_of(session), frame_of(session), {.norm = norm, .edges = edges});
      // Both search; brackets of the same number overlap.
      EXPECT_LE(score.epsilon.lower, expected.upper * (1.0 + 1e-9));
      EXPECT_LE(expected.lower, score.epsilon.upper * (1.0 + 1e-9));
      EXPECT_GT(score.volume, 0.0);
      EXPECT_FALSE(score.limiting_link.empty());
      EXPECT_LE(score.epsilon_without, score.epsilon.upper);
    }
  }
}

// A section is cut from the hull whose volume is told: each of its corners lies in the space.
TEST(Judge, TheSectionOfOnesOwnLiesInTheSpace) {
  Session session = held_mug();
  const FixedCoordinates fixed{.coordinates = {0, 2, 4}, .values = {0.01, -0.02, 0.0}};
  session.set_judge({.fixed = fixed});
  const GraspScore score = session.quality(true);
  ASSERT_FALSE(score.chosen.empty());
  EXPECT_EQ(score.chosen.coordinates, (std::array<int, 3>{1, 3, 5}));
  const std::unique_ptr<SupportMap> space = wrench_space(points_of(session), frame_of(session));
  for (Eigen::Index i = 0; i < score.chosen.vertices.cols(); ++i) {
    Wrench corner = Wrench::Zero();
    for (int k = 0; k < 3; ++k) {
      corner[fixed.coordinates[static_cast<std::size_t>(k)]] = fixed.values[k];
      corner[score.chosen.coordinates[static_cast<std::size_t>(k)]] = score.chosen.vertices(k, i);
    }
    for (int k = 0; k < 6; ++k) {
      for (const double sign : {-1.0, 1.0}) {
        const Wrench direction = sign * Wrench::Unit(k);
        EXPECT_LE(corner.dot(direction), space->support(direction).dot(direction) + 1e-9);
      }
    }
  }
  EXPECT_TRUE(session.quality(false).chosen.empty());
}

TEST(Judge, RefusesWhatNoSpaceHas) {
  Session session;
  EXPECT_EQ(refusal_of([&] { session.set_judge({.edges = 2}); }).field(), "edges");
  EXPECT_EQ(refusal_of([&] { session.set_judge({.edges = 65}); }).field(), "edges");
  const FixedCoordinates twice{.coordinates = {0, 1, 0}, .values = Vector3::Zero()};
  EXPECT_EQ(refusal_of([&] { session.set_judge({.fixed = twice}); }).field(), "fixed");
  EXPECT_EQ(session.undo_count(), 0U);
}

TEST(Judge, FrictionIsThatOfTheContactsAndStaysInTheSceneFile) {
  Session session = held_mug();
  const double before = session.contacts().front().point.friction;
  session.edit([](Scene& scene) { change_friction(scene, std::nullopt, 0.31); });
  for (const GraspContact& contact : session.contacts()) {
    EXPECT_EQ(contact.point.friction, 0.31);
  }
  EXPECT_NE(scene_text(session.state().world->scene()).find("0.31"), std::string::npos);
  ASSERT_TRUE(session.undo());
  EXPECT_EQ(session.contacts().front().point.friction, before);
}

TEST(Judge, SlidingSurfacesHaveNoMoreFrictionThanStickingOnes) {
  Scene scene = load_scene("mug");
  const Material of_object = scene.object.material;
  scene.kinetic_friction.set(of_object, Material::rubber, 0.5);
  change_friction(scene, Material::rubber, 0.6);
  EXPECT_EQ(scene.kinetic_friction.between(of_object, Material::rubber), 0.5);
  change_friction(scene, Material::rubber, 0.4);
  EXPECT_EQ(scene.friction.between(Material::rubber, of_object), 0.4);
  EXPECT_EQ(scene.kinetic_friction.between(of_object, Material::rubber), std::nullopt);
}

}  // namespace
}  // namespace prehend::test
