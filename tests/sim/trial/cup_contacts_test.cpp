// Trials of hands with suction cups: where they seal, what they hold in closed form.
#include "sim/trial/cup_contacts.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "sim/base/gravity.h"
#include "sim/shape/basic_shapes.h"
#include "sim/trial/payload_margin.h"
#include "sim/trial/run_trial.h"
#include "tests/support/refusal_of.h"
#include "tests/support/scenes.h"
#include "tests/support/trial_bytes.h"

namespace prehend {
namespace {

constexpr double kBoxMass = 0.5;
constexpr double kLipFriction = 0.6;
constexpr double kForcesSolved = 1e-5;  // relative error of the forces

// The hand comes from 0.15 m away along `approach`, with its origin up to 10 mm into `target`.
Candidate cup_onto(const Robot& robot, const Vector3& target, const Vector3& approach) {
  const Hand& hand = *robot.hand;
  Matrix3 of_hand;
  of_hand << hand.approach, hand.closing, hand.approach.cross(hand.closing);
  const Vector3 closing = approach.unitOrthogonal();
  Matrix3 wanted;
  wanted << approach, closing, approach.cross(closing);
  const Matrix3 rotation = wanted * of_hand.transpose();
  Candidate candidate;
  candidate.X_OH = pose_from(rotation, target + 0.01 * approach - rotation * hand.origin);
  candidate.approach_O = approach;
  candidate.approach_distance = 0.15;
  candidate.preshape = 0;
  return candidate;
}

Scene cup_and_box(const char* hand, const Vector3& size = {0.1, 0.1, 0.1}) {
  Scene scene = test::scene_with(find_robot(hand), make_box(size));
  scene.object.mass = kBoxMass;
  scene.friction.set(Material::rubber, Material::plastic, kLipFriction);
  return scene;
}

const Vector3 kOntoTop = -Vector3::UnitZ();
const Vector3 kBoxTop = {0.0, 0.0, 0.05};

TEST(CupTrial, ACupHoldsABoxByItsTop) {
  const CompiledScene scene = compile(cup_and_box("suction_cup_30"));
  const Trial trial = run_trial(scene, cup_onto(scene.scene.hand, kBoxTop, kOntoTop));
  EXPECT_EQ(trial.outcome, Outcome::stable);
  ASSERT_EQ(trial.contacts.size(), 1U);
  const Contact& cup = trial.contacts[0].point;
  EXPECT_EQ(cup.model, ContactModel::suction);
  EXPECT_LT((cup.position - kBoxTop).norm(), 1e-9);
  EXPECT_LT((cup.normal - kOntoTop).norm(), 1e-12);
  EXPECT_EQ(cup.friction, kLipFriction);
  EXPECT_LT(trial.contacts[0].gap, 1e-4);
  EXPECT_EQ(test::collision(scene, trial.X_OH, trial.joints), "");
}

// How often the weight is held in closed form: by the vacuum V below the cup; at the distance a
// from its axis as long as m g a k is at most the elastic torque K r^2 0.1 / 2; from the side at
// the distance a below the lip of that as well.
TEST(CupTrial, WeightIsHeldAsOftenAsTheRingBears) {
  const CompiledScene scene = compile(cup_and_box("suction_cup_30"));
  const SuctionCup& cup = scene.scene.hand.hand->cups[0];
  const double weight = kBoxMass * kStandardGravity;
  const double elastic = 0.5 * cup.lip_stiffness * cup.strain * cup.radius * cup.radius;
  const auto strength = [&](const Vector3& target, const Vector3& approach) {
    const Trial trial = run_trial(scene, cup_onto(scene.scene.hand, target, approach));
    EXPECT_EQ(trial.outcome, Outcome::stable);
    EXPECT_EQ(can_lift(scene, trial), payload_margin(scene, trial).holds());
    return payload_margin(scene, trial).given.strength;
  };
  EXPECT_NEAR(strength(kBoxTop, kOntoTop), cup.pull / weight, kForcesSolved * cup.pull / weight);
  EXPECT_NEAR(strength({0.02, 0.0, 0.05}, kOntoTop), elastic / (0.02 * weight), 1e-4);
  EXPECT_NEAR(strength({0.0, 0.0, 0.02}, kOntoTop), cup.pull / weight,
              1e-4);  // aims at the top too
  EXPECT_NEAR(strength({-0.05, 0.0, 0.0}, Vector3::UnitX()), elastic / (0.05 * weight), 1e-4);
}

TEST(CupTrial, FourCupsHoldFourTimesAsMuch) {
  const CompiledScene scene = compile(cup_and_box("suction_array_4"));
  const Trial trial = run_trial(scene, cup_onto(scene.scene.hand, kBoxTop, kOntoTop));
  EXPECT_EQ(trial.outcome, Outcome::stable);
  ASSERT_EQ(trial.contacts.size(), 4U);
  const double expected = 4.0 * 42.0 / (kBoxMass * kStandardGravity);
  EXPECT_NEAR(payload_margin(scene, trial).given.strength, expected, kForcesSolved * expected);
  // At the border two cups are beside the box, the others hold.
  const Trial aside = run_trial(scene, cup_onto(scene.scene.hand, {0.04, 0.0, 0.05}, kOntoTop));
  EXPECT_EQ(aside.outcome, Outcome::stable);
  EXPECT_EQ(aside.contacts.size(), 2U);
}

TEST(CupTrial, ATiltedCupGivesWay) {
  const CompiledScene scene = compile(cup_and_box("suction_cup_30"));
  const SuctionCup& cup = scene.scene.hand.hand->cups[0];
  for (const double angle : {0.1, 0.25, 0.4}) {
    const Vector3 approach(std::sin(angle), 0.0, -std::cos(angle));
    const Trial trial = run_trial(scene, cup_onto(scene.scene.hand, kBoxTop, approach));
    const double apart = 2.0 * cup.radius * std::tan(angle);
    if (apart > cup.travel) {
      EXPECT_EQ(trial.outcome, Outcome::no_seal);
      continue;
    }
    ASSERT_EQ(trial.outcome, Outcome::stable) << angle;
    // The body of the lip is a prism inside of the circle.
    EXPECT_NEAR(trial.contacts[0].gap, apart, 5e-4);
  }
}

TEST(CupTrial, EdgesAndPorousPlacesAreNotHeld) {
  Scene scene = cup_and_box("suction_cup_30");
  const Robot hand = scene.hand;
  EXPECT_EQ(run_trial(compile(scene), cup_onto(hand, {0.04, 0.0, 0.05}, kOntoTop)).outcome,
            Outcome::no_seal);
  SurfaceRegion half;
  half.inside = {Box{{0.1, 0.2, 0.2}}, translation({0.05, 0.0, 0.0})};
  scene.porous.push_back(half);
  const CompiledScene porous = compile(scene);
  EXPECT_EQ(run_trial(porous, cup_onto(hand, {0.02, 0.0, 0.05}, kOntoTop)).outcome,
            Outcome::no_seal);
  EXPECT_EQ(run_trial(porous, cup_onto(hand, {-0.02, 0.0, 0.05}, kOntoTop)).outcome,
            Outcome::stable);
  const std::vector<CupSeal> seals =
      cup_seals(porous, run_trial(porous, cup_onto(hand, {0.0, 0.0, 0.05}, kOntoTop)).X_OH);
  ASSERT_EQ(seals.size(), 1U);
  EXPECT_EQ(seals[0].end, SealEnd::porous);
}

TEST(CupTrial, CupsWiderThanTheObjectAreRefused) {
  const InputError error = test::refusal_of([] {
    (void)compile(cup_and_box("suction_cup_30", {0.2, 0.02, 0.02}));
  });
  EXPECT_NE(std::string(error.what()).find("30 mm wide, more than the object"), std::string::npos)
      << error.what();
  EXPECT_NO_THROW((void)compile(cup_and_box("suction_cup_30", {0.2, 0.022, 0.022})));
}

TEST(CupTrial, IsAPureFunction) {
  const CompiledScene scene = compile(cup_and_box("suction_array_4"));
  const Candidate candidate = cup_onto(scene.scene.hand, {0.01, 0.02, 0.05}, kOntoTop);
  EXPECT_EQ(test::bytes_of(run_trial(scene, candidate)),
            test::bytes_of(run_trial(scene, candidate)));
}

}  // namespace
}  // namespace prehend
