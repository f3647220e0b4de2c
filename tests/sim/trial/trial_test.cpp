// Whole trials: grasps that must hold, outcomes, and that a trial is a pure function.
#include "sim/trial/trial.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "sim/base/random.h"
#include "sim/shape/object_generator.h"
#include "sim/trial/candidate.h"
#include "sim/trial/grasp_contacts.h"
#include "sim/trial/run_trial.h"
#include "tests/support/scenes.h"
#include "tests/support/trial_bytes.h"

namespace prehend {
namespace {

using test::compiled;

// The hand comes from 0.2 m away along `approach`, closes along `closing`, and stops at the latest
// with its origin at `target`.
Candidate aimed(const Robot& robot, const Vector3& target, const Vector3& approach,
                const Vector3& closing) {
  const Hand& hand = *robot.hand;
  Matrix3 of_hand;
  of_hand << hand.approach, hand.closing, hand.approach.cross(hand.closing);
  Matrix3 wanted;
  wanted << approach, closing, approach.cross(closing);
  const Matrix3 rotation = wanted * of_hand.transpose();
  Candidate candidate;
  candidate.X_OH = pose_from(rotation, target - rotation * hand.origin);
  candidate.approach_O = approach;
  candidate.approach_distance = 0.2;
  candidate.preshape = 0;
  return candidate;
}

// Both plates hold, each with a region: a line or an area.
void expect_held_by_plates(const CompiledScene& scene, const Candidate& candidate) {
  const Trial trial = run_trial(scene, candidate);
  EXPECT_EQ(trial.outcome, Outcome::stable);
  EXPECT_GT(trial.epsilon.lower, 0.01);
  std::map<std::string, int> points;
  for (const GraspContact& contact : trial.contacts) {
    ++points[scene.links[index(contact.link)].name];
  }
  EXPECT_GE(points["left_plate"], 2);
  EXPECT_GE(points["right_plate"], 2);
  EXPECT_EQ(test::collision(scene, trial.X_OH, trial.joints), "");
}

const Vector3 kX = Vector3::UnitX();
const Vector3 kY = Vector3::UnitY();
const Vector3 kZ = Vector3::UnitZ();

TEST(Trial, AWideJawHoldsTheMugFromAboveAndFromTheSide) {
  const Robot hand = find_robot("parallel_jaw_wide");
  const CompiledScene scene = compiled(hand, generate_object("mug"));
  const Vector3 middle(0.0, 0.0, 0.0525);
  expect_held_by_plates(scene, aimed(hand, middle, -kZ, kY));
  expect_held_by_plates(scene, aimed(hand, middle, kX, kY));  // opposite the handle
}

TEST(Trial, AWideJawHoldsACubeByFourCornersAPlate) {
  const Robot hand = find_robot("parallel_jaw_wide");
  for (const int cells : {1, 8}) {
    const CompiledScene scene = compiled(hand, make_box({0.05, 0.05, 0.05}, cells));
    const Candidate candidate = aimed(hand, Vector3::Zero(), -kZ, kX);
    expect_held_by_plates(scene, candidate);
    const Trial trial = run_trial(scene, candidate);
    // Plates of 40 mm: the palm on the top (a region of its own) and four corners for each plate.
    // The plates are rubber: each also bears on one patch, in the middle of its corners.
    std::map<std::pair<LinkId, ContactModel>, int> count;
    for (const GraspContact& contact : trial.contacts) ++count[{contact.link, contact.point.model}];
    for (const LinkId link : {LinkId{1}, LinkId{2}}) {
      EXPECT_EQ((count[{link, ContactModel::point}]), 4);
      EXPECT_EQ((count[{link, ContactModel::soft_finger}]), 1);
    }
    for (const GraspContact& contact : trial.contacts) {
      if (contact.link == LinkId{0}) continue;
      const bool soft = contact.point.model == ContactModel::soft_finger;
      EXPECT_NEAR(std::abs(contact.point.position.x()), 0.025, 1e-12);
      EXPECT_NEAR(std::abs(contact.point.position.y()), soft ? 0.0 : 0.02, 1e-9);
      EXPECT_NEAR(contact.point.normal.x() * contact.point.position.x(), -0.025, 1e-9);
      EXPECT_EQ(contact.point.friction, 1.0);  // rubber on plastic
    }
  }
}

TEST(Trial, AWideJawHoldsACylinder) {
  const Robot hand = find_robot("parallel_jaw_wide");
  const CompiledScene scene = compiled(hand, make_cylinder(0.03, 0.1));
  expect_held_by_plates(scene, aimed(hand, Vector3::Zero(), -kZ, kY));
  expect_held_by_plates(scene, aimed(hand, Vector3::Zero(), kX, kY));
}

TEST(Trial, OfTheSameCandidateGivesTheSameBytes) {
  Random random(121);
  const Robot hand = find_robot("barrett");
  const CompiledScene scene = compiled(hand, generate_object("mug", 1000));
  std::vector<Candidate> candidates;
  std::vector<std::vector<unsigned char>> first;
  for (int i = 0; i < 12; ++i) {
    const Vector3 approach = random.direction();
    candidates.push_back(aimed(hand, {0.0, 0.0, 0.05}, approach, any_orthogonal(approach)));
    candidates.back().preshape = i % 4;
    first.push_back(test::bytes_of(run_trial(scene, candidates.back())));
  }
  // In another order, and on a scene compiled anew.
  const CompiledScene again = compile(scene.scene);
  for (std::size_t i = candidates.size(); i-- > 0;) {
    EXPECT_EQ(test::bytes_of(run_trial(again, candidates[i])), first[i]) << i;
  }
}

TEST(Trial, NamesWhatBlocks) {
  const Robot hand = find_robot("parallel_jaw_wide");
  const TriangleMesh cube = make_box({0.05, 0.05, 0.05});
  const Candidate candidate = aimed(hand, Vector3::Zero(), -kZ, kX);
  const auto with = [&](const TriangleMesh& mesh, const Vector3& at) {
    return run_trial(compiled(hand, cube, {test::obstacle(mesh, at)}), candidate);
  };
  const Trial on_the_way = with(make_box({0.3, 0.02, 0.001}), {0.0, 0.0, 0.06});
  EXPECT_EQ(on_the_way.outcome, Outcome::approach_blocked);
  ASSERT_TRUE(on_the_way.blocked.has_value());
  EXPECT_EQ(on_the_way.blocked->body, BodyId::obstacle(0));
  EXPECT_TRUE(on_the_way.contacts.empty());
  const Trial at_start = with(make_box({0.3, 0.1, 0.001}), {0.0, 0.0, 0.22});
  EXPECT_EQ(at_start.outcome, Outcome::hand_blocked);
  ASSERT_TRUE(at_start.blocked.has_value());
  EXPECT_EQ(at_start.blocked->body, BodyId::obstacle(0));
  EXPECT_EQ(at_start.blocked->link, LinkId{0});
  EXPECT_EQ(at_start.travel, 0.0);

  Candidate away = candidate;
  away.X_OH = translation({0.0, 0.5, 0.0}) * away.X_OH;
  EXPECT_EQ(run_trial(compiled(hand, cube), away).outcome, Outcome::no_contact);
  away.X_OH = candidate.X_OH;
  away.approach_distance = 0.0;
  const Trial inside = run_trial(compiled(hand, cube), away);
  EXPECT_EQ(inside.outcome, Outcome::hand_blocked);
  ASSERT_TRUE(inside.blocked.has_value());
  EXPECT_TRUE(inside.blocked->body.is_object());
}

// A stick of 8 mm on a table: the plates are long enough to reach 40 mm deeper.
TEST(Trial, TheFingersCloseBesideTheTableOnWhatLiesFlat) {
  const Robot hand = find_robot("parallel_jaw_wide");
  const TriangleMesh stick = make_box({0.14, 0.008, 0.008});
  const StaticBody table = test::obstacle(make_box({1.0, 1.0, 0.02}), {0.0, 0.0, -0.0145});
  const CompiledScene scene = compiled(hand, stick, {table});
  const Candidate candidate = aimed(hand, {0.0, 0.0, 0.03}, -kZ, kY);
  TrialOptions options;
  options.back_off_tries = 0;
  const Trial trial = run_trial(scene, candidate, options);
  EXPECT_EQ(trial.outcome, Outcome::stable);
  EXPECT_EQ(test::collision(scene, trial.X_OH, trial.joints), "");
  options.obstacle_clearance = 3e-3;
  const Trial higher = run_trial(scene, candidate, options);
  EXPECT_EQ(higher.outcome, Outcome::stable);
  EXPECT_NEAR(trial.travel - higher.travel, 2e-3, 1e-12);
  // Beyond the stick there is nothing to hold.
  options.obstacle_clearance = 0.02;
  const Trial above = run_trial(scene, candidate, options);
  EXPECT_EQ(above.outcome, Outcome::approach_blocked);
  EXPECT_EQ(above.blocked->body, BodyId::obstacle(0));
  EXPECT_TRUE(above.contacts.empty());
}

TEST(Trial, BacksOffWhereTheFirstClosingDoesNotHold) {
  Random random(122);
  const Robot hand = find_robot("barrett");
  const CompiledScene scene = compiled(hand, generate_object("mug", 1000));
  const TrialOptions options;
  TrialOptions without = options;
  without.back_off_tries = 0;
  int held_later = 0;
  for (int i = 0; i < 30; ++i) {
    const Vector3 approach = random.direction();
    Candidate candidate =
        aimed(hand, scene.object().mesh.ball_center(), approach, any_orthogonal(approach));
    candidate.preshape = static_cast<int>(random.index(hand.hand->preshapes.size()));
    const Trial trial = run_trial(scene, candidate, options);
    const Trial once = run_trial(scene, candidate, without);
    EXPECT_EQ(once.back_offs, 0);
    // Backing off happens only where the first closing does not hold, and counts only where it then
    // does.
    EXPECT_EQ(trial.back_offs > 0,
              once.outcome != Outcome::stable && trial.outcome == Outcome::stable);
    EXPECT_LE(trial.back_offs, options.back_off_tries);
    EXPECT_NEAR(once.travel - trial.travel, trial.back_offs * options.back_off_step, 1e-12);
    if (trial.back_offs == 0) continue;
    ++held_later;
    EXPECT_EQ(test::collision(scene, trial.X_OH, trial.joints), "");
  }
  EXPECT_GT(held_later, 0);
}

TEST(Trial, ItsContactsAreThoseOfItsPosture) {
  const Robot hand = find_robot("parallel_jaw_wide");
  const CompiledScene scene = compiled(hand, generate_object("mug", 2000));
  const TrialOptions options;
  const Trial trial = run_trial(scene, aimed(hand, {0.0, 0.0, 0.05}, -kZ, kY), options);
  const auto again = grasp_contacts(scene, trial.X_OH, trial.joints, options);
  ASSERT_EQ(again.size(), trial.contacts.size());
  for (std::size_t i = 0; i < again.size(); ++i) {
    EXPECT_EQ(again[i].link, trial.contacts[i].link);
    EXPECT_EQ(again[i].point.position, trial.contacts[i].point.position);
  }
  EXPECT_EQ(contacts_of(again).size(), again.size());
}

// Obstacles that neither the hand nor the object can reach change no bit of a trial, however many.
TEST(Trial, ObstaclesOutOfReachChangeNothing) {
  const Robot hand = find_robot("parallel_jaw_wide");
  const TriangleMesh table = test::block({0.6, 0.6, 0.02}, {0.0, 0.0, -0.011});
  const std::vector<StaticBody> near{test::obstacle(table, Vector3::Zero())};
  std::vector<StaticBody> many = near;
  Random random(5);
  for (int k = 0; k < 60; ++k) {
    const double angle = random.uniform(0.0, 6.28);
    many.push_back(test::obstacle(test::block({0.1, 0.1, 0.3}, Vector3::Zero()),
                                  {2.0 * std::cos(angle), 2.0 * std::sin(angle), 0.2}));
  }
  const CompiledScene few_scene = compiled(hand, generate_object("mug", 1000), near);
  const CompiledScene many_scene = compiled(hand, generate_object("mug", 1000), many);
  const Vector3 middle(0.0, 0.0, 0.0525);
  for (const Candidate& candidate :
       {aimed(hand, middle, -kZ, kY), aimed(hand, middle, -kZ, kX), aimed(hand, middle, kX, kY),
        aimed(hand, middle, kX, kZ), aimed(hand, middle, kZ, kX)}) {
    EXPECT_EQ(test::bytes_of(run_trial(few_scene, candidate)),
              test::bytes_of(run_trial(many_scene, candidate)));
  }
}

}  // namespace
}  // namespace prehend
