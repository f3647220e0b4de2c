// Random trials, every posture and every contact judged by trying all triangles.
#include <cmath>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "sim/base/random.h"
#include "sim/shape/object_generator.h"
#include "sim/trial/candidate.h"
#include "sim/trial/run_trial.h"
#include "tests/support/repeats.h"
#include "tests/support/scenes.h"

namespace prehend {
namespace {

// The threshold of contact and the rounding of poses.
constexpr double kTouching = 1e-4 + 1e-9;

struct Tally {
  int trials = 0;
  int with_contacts = 0;
  int contacts = 0;
  int with_obstacles = 0;
  std::map<std::string, int> outcomes;
};

// A table under the object, and sometimes a block beside it.
std::vector<StaticBody> random_obstacles(Random& random, const Bounds& object) {
  std::vector<StaticBody> bodies;
  bodies.push_back(
      test::obstacle(make_box({0.6, 0.6, 0.02}), {0.0, 0.0, object.lower.z() - 0.011}));
  if (random.index(2) == 0) {
    const double angle = random.uniform(0.0, 6.28);
    const Vector3 beside = 0.09 * Vector3(std::cos(angle), std::sin(angle), 0.0);
    bodies.push_back(test::obstacle(make_box({0.03, 0.04, 0.1}), object.center() + beside));
  }
  return bodies;
}

// The hand comes from outside towards a point in or near the object, turned any way about its
// approach.
Candidate random_candidate(Random& random, const CompiledScene& scene) {
  const Hand& hand = *scene.scene.hand.hand;
  Candidate candidate;
  const Matrix3 rotation = random.rotation();
  candidate.approach_O = rotation * hand.approach;
  const Vector3 target = scene.object().mesh.ball_center() + random.in_box(0.02);
  const double short_of = random.uniform(0.0, 0.12);
  candidate.X_OH =
      pose_from(rotation, target - short_of * candidate.approach_O - rotation * hand.origin);
  candidate.approach_distance = random.uniform(0.1, 0.4);
  candidate.preshape = static_cast<int>(random.index(hand.preshapes.size()));
  if (random.index(3) > 0) return candidate;
  // Any opening: up to half closed from the preshape's.
  candidate.dofs = hand.preshapes[index(*candidate.preshape)].dofs;
  candidate.preshape.reset();
  for (std::size_t d = 0; d < candidate.dofs.size(); ++d) {
    const DegreeOfFreedom& dof = scene.scene.hand.dofs[d];
    const double end = dof.closing_velocity > 0.0   ? dof.upper
                       : dof.closing_velocity < 0.0 ? dof.lower
                                                    : candidate.dofs[d];
    candidate.dofs[d] += random.uniform(0.0, 0.5) * (end - candidate.dofs[d]);
  }
  return candidate;
}

void check_contacts(const CompiledScene& scene, const Trial& trial,
                    const std::vector<std::vector<test::Corners>>& links) {
  const auto object = test::soup(scene.object().mesh.mesh());
  for (const GraspContact& contact : trial.contacts) {
    const Vector3& p = contact.point.position;
    EXPECT_LE(test::point_to_surface(p, object), kTouching);
    const std::size_t link = index(contact.link);
    const bool soft = contact.point.model == ContactModel::soft_finger;
    EXPECT_LE(test::point_to_surface(p, links[link]),
              soft ? scene.links[link].compliant_depth + 1e-9 : kTouching);
    EXPECT_NEAR(contact.point.normal.norm(), 1.0, 1e-9);
    // On the link's side of the surface is free space.
    EXPECT_EQ(test::winding(p - 1e-5 * contact.point.normal, object), 0);
  }
}

// True when the hand as it starts is free of collisions with itself: what a candidate owes.
bool starts_free_of_itself(const CompiledScene& scene, const Candidate& candidate) {
  if (candidate.preshape) return true;
  const auto links =
      test::link_soups(scene, Pose::Identity(), joint_values(scene.scene.hand, candidate.dofs));
  for (const LinkPair& pair : scene.self_pairs) {
    if (test::surfaces_meet(links[static_cast<std::size_t>(pair.a)],
                            links[static_cast<std::size_t>(pair.b)])) {
      return false;
    }
  }
  return true;
}

void check_trial(const CompiledScene& scene, const Candidate& candidate, Tally& tally) {
  const Trial trial = run_trial(scene, candidate);
  ++tally.trials;
  ++tally.outcomes[std::string(name_of(trial.outcome))];
  tally.with_contacts += !trial.contacts.empty();
  tally.contacts += static_cast<int>(trial.contacts.size());
  tally.with_obstacles += scene.has_obstacles();
  const auto links = test::link_soups(scene, trial.X_OH, trial.joints);
  const std::string collision = test::what_collides(links, scene);
  if (trial.outcome == Outcome::hand_blocked) {
    EXPECT_NE(collision, "") << "called blocked by its link " << collision_of(scene, trial).link;
    EXPECT_TRUE(trial.contacts.empty());
    return;
  }
  EXPECT_EQ(collision, "");
  check_contacts(scene, trial, links);
}

void run_random_trials(const std::string& hand, std::uint64_t seed, int count) {
  Random random(seed);
  Tally tally;
  const Robot robot = find_robot(hand);
  for (const char* name : {"mug", "ball", "box", "bottle", "wine_glass"}) {
    const TriangleMesh object = generate_object(name, 1500);
    const CompiledScene free = test::compiled(robot, object);
    const CompiledScene crowded =
        test::compiled(robot, object, random_obstacles(random, bounds(object)));
    for (int i = 0; i < count;) {
      const CompiledScene& scene = i % 3 == 0 ? crowded : free;
      const Candidate candidate = random_candidate(random, scene);
      if (!starts_free_of_itself(scene, candidate)) continue;
      SCOPED_TRACE(hand + " on " + name + ", seed " + std::to_string(seed) + ", trial " +
                   std::to_string(i));
      check_trial(scene, candidate, tally);
      if (testing::Test::HasFailure()) return;
      ++i;
    }
  }
  std::string outcomes;
  for (const auto& [name, n] : tally.outcomes) outcomes += " " + name + " " + std::to_string(n);
  testing::Test::RecordProperty("outcomes", outcomes);
  testing::Test::RecordProperty("contacts", tally.contacts);
  // Most trials must reach the object for the test to mean something.
  EXPECT_GE(tally.with_contacts, tally.trials / 3) << outcomes;
  EXPECT_GE(tally.with_obstacles, tally.trials / 4);
}

TEST(RandomTrials, BarrettContactsAreWithinTheThresholdAndNothingPenetrates) {
  run_random_trials("barrett", 71, test::repeats(16));
}
TEST(RandomTrials, WideJawContactsAreWithinTheThresholdAndNothingPenetrates) {
  run_random_trials("parallel_jaw_wide", 72, test::repeats(16));
}
TEST(RandomTrials, FrankaContactsAreWithinTheThresholdAndNothingPenetrates) {
  run_random_trials("franka_hand", 73, test::repeats(16));
}

}  // namespace
}  // namespace prehend
