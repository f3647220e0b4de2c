// The squeeze that a weight needs, in closed form, and what the hand's drives can give.
#include "sim/trial/payload_margin.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "sim/base/gravity.h"
#include "sim/base/random.h"
#include "sim/quality/forces.h"
#include "sim/shape/object_generator.h"
#include "sim/trial/candidate.h"
#include "sim/trial/grasp_contacts.h"
#include "sim/trial/run_trial.h"
#include "tests/support/scenes.h"

namespace prehend {
namespace {

constexpr double kMass = 0.5;
constexpr double kFriction = 0.6;
constexpr double kEffort = 70.0;  // of a finger of the Franka hand
const double kWeight = kMass * kStandardGravity;

// The Franka hand, its fingers closing along x around a bar of 12 mm whose middle is between the
// pads, hand above or below as `X_WO` says: the hand's approach is along z of the object.
struct Held {
  CompiledScene scene;
  Trial trial;
};

Held held_bar(const Pose& X_WO, double mass = kMass, const Vector3& center_of_mass = {0, 0, 0}) {
  Scene scene = test::scene_with(find_robot("franka_hand"), make_box({0.012, 0.12, 0.02}));
  scene.object.mass = mass;
  scene.object.center_of_mass = center_of_mass;
  scene.object.X_WO = X_WO;
  scene.friction.set(Material::rubber, Material::plastic, kFriction);
  Held held{compile(std::move(scene)), {}};
  Candidate candidate;
  const double reach = held.scene.scene.hand.hand->origin.z() + 0.0373;
  candidate.X_OH = translation({0.0, 0.0, -reach});
  candidate.preshape = 0;
  held.trial = run_trial(held.scene, candidate);
  EXPECT_EQ(held.trial.outcome, Outcome::stable);
  return held;
}

Pose turned(double angle, const Vector3& axis) { return Pose(Eigen::AngleAxisd(angle, axis)); }

// Gravity along the pads: each bears half of the weight by friction.
TEST(HoldWeight, ByFrictionTakesTheWeightOverTheCoefficient) {
  const Held held = held_bar(Pose::Identity());
  const PayloadMargin holding = payload_margin(held.scene, held.trial);
  EXPECT_LT((holding.given.down_O + Vector3::UnitZ()).norm(), 1e-12);
  EXPECT_NEAR(holding.given.sum_of_normals, kWeight / kFriction, 1e-3);
  const double strength = 2.0 * kEffort * kFriction / kWeight;
  EXPECT_LE(holding.given.strength, strength * (1.0 + 1e-6));
  EXPECT_GE(holding.given.strength, strength * 0.989);
  EXPECT_TRUE(holding.holds());
  EXPECT_GE(holding.worst.sum_of_normals, holding.given.sum_of_normals);
}

// Gravity along the closing direction: the finger below bears all, with the drives of both, which
// are one.
TEST(HoldWeight, OnOneFingerTakesTheWeight) {
  const Held held = held_bar(turned(0.5 * std::numbers::pi, Vector3::UnitY()));
  const PayloadMargin holding = payload_margin(held.scene, held.trial);
  EXPECT_NEAR(std::abs(holding.given.down_O.x()), 1.0, 1e-12);
  EXPECT_NEAR(holding.given.sum_of_normals, kWeight, 1e-3);
  EXPECT_NEAR(holding.given.strength, 2.0 * kEffort / kWeight, 0.011 * 2.0 * kEffort / kWeight);
}

TEST(HoldWeight, ScalesWithTheWeight) {
  const Held light = held_bar(Pose::Identity(), kMass);
  const Held heavy = held_bar(Pose::Identity(), 20.0 * kMass);
  const PayloadMargin one = payload_margin(light.scene, light.trial);
  const PayloadMargin twenty = payload_margin(heavy.scene, heavy.trial);
  EXPECT_NEAR(twenty.given.sum_of_normals / one.given.sum_of_normals, 20.0, 1e-5);
  EXPECT_NEAR(one.given.strength / twenty.given.strength, 20.0, 0.25);
  EXPECT_FALSE(twenty.holds());
}

// A bar whose weight hangs beside the fingers turns about the closing direction: the farther, the
// harder the squeeze.
TEST(HoldWeight, AtTheEndNeedsMoreThanAtTheCentreOfMass) {
  const Held centred = held_bar(Pose::Identity());
  const double least = payload_margin(centred.scene, centred.trial).given.sum_of_normals;
  double before = least;
  for (const double off : {0.01, 0.02, 0.03, 0.04}) {
    const Held held = held_bar(Pose::Identity(), kMass, {0.0, off, 0.0});
    const PayloadMargin holding = payload_margin(held.scene, held.trial);
    EXPECT_GT(holding.given.sum_of_normals, before);
    before = holding.given.sum_of_normals;
  }
  EXPECT_GT(before, 2.0 * least);
}

// In the palm the weight loads no finger.
TEST(HoldWeight, WhatLiesOnThePalmLoadsNoDrive) {
  Scene scene = test::scene_with(find_robot("franka_hand"), make_box({0.05, 0.02, 0.08}));
  scene.object.mass = 100.0;
  scene.object.X_WO = turned(0.0, Vector3::UnitX());
  const CompiledScene compiled = compile(std::move(scene));
  Candidate candidate;
  candidate.X_OH = translation({0.0, 0.0, -0.04 - 0.06595 - 2e-5});
  candidate.preshape = 0;
  const Trial trial = run_trial(compiled, candidate);
  ASSERT_FALSE(trial.contacts.empty());
  const PayloadMargin holding = payload_margin(compiled, trial);
  EXPECT_TRUE(std::isinf(holding.given.strength));
  EXPECT_TRUE(holding.holds());
}

TEST(HoldWeight, WithoutStatedEffortsOrContactsThereIsNoLimitOrNothing) {
  const CompiledScene scene =
      test::compiled(find_robot("parallel_jaw"), make_box({0.05, 0.03, 0.05}));
  Candidate candidate;
  candidate.X_OH = translation({0.0, 0.0, -0.06});
  candidate.preshape = 0;
  const Trial trial = run_trial(scene, candidate);
  ASSERT_EQ(trial.outcome, Outcome::stable);
  EXPECT_TRUE(std::isinf(payload_margin(scene, trial).given.strength));
  const PayloadMargin nothing = payload_margin(scene, Trial{});
  EXPECT_EQ(nothing.given.strength, 0.0);
  EXPECT_TRUE(std::isinf(nothing.worst.sum_of_normals));
}

// No attitude of many random ones is worse by more than stated, in a grasp of many contacts.
TEST(HoldWeight, TheWorstAttitudeIsWithinItsBound) {
  Random random(77);
  Held held = held_bar(Pose::Identity(), kMass, {0.0, 0.01, 0.0});
  const PayloadMargin holding = payload_margin(held.scene, held.trial);
  ASSERT_TRUE(std::isfinite(holding.worst.sum_of_normals));
  for (int i = 0; i < 200; ++i) {
    const double angle = random.uniform(0.0, std::numbers::pi);
    held.scene.scene.object.X_WO = turned(angle, random.direction());
    const ContactForces forces =
        balancing_forces(contacts_of(held.trial.contacts), held.scene.wrench_frame,
                         (Wrench() << kWeight * random.direction(), Vector3::Zero()).finished(),
                         {.measure = ForceMeasure::sum_of_normals});
    EXPECT_LE(forces.sum_of_normals, 1.09 * holding.worst.sum_of_normals);
  }
}

// The Jacobian is the motion of the contact point with its link, by differences.
TEST(HandTorques, AreTheMotionsOfContactPoints) {
  Random random(78);
  const Robot hand = find_robot("allegro");
  const CompiledScene scene = test::compiled(hand, generate_object("mug", 1000));
  Trial trial;
  trial.X_OH = turned(0.7, random.direction());
  trial.X_OH.translation() = Vector3(0.1, -0.2, 0.05);
  for (const Joint& joint : hand.joints) {
    trial.joints.push_back(random.uniform(joint.lower, joint.upper));
  }
  for (std::size_t l = 0; l < hand.links.size(); ++l) {
    GraspContact contact;
    contact.link = link_id(l);
    contact.point.position = 0.1 * random.direction();
    contact.point.normal = random.direction();
    trial.contacts.push_back(contact);
  }
  const HandTorques torques = hand_torques(scene, trial);
  const std::vector<Pose> now = test::link_poses_in_object(scene, trial.X_OH, trial.joints);
  constexpr double kStep = 1e-6;
  for (std::size_t j = 0; j < hand.joints.size(); ++j) {
    std::vector<double> joints = trial.joints;
    joints[j] += kStep;
    const std::vector<Pose> then = test::link_poses_in_object(scene, trial.X_OH, joints);
    for (std::size_t l = 0; l < hand.links.size(); ++l) {
      const Vector3 p_O = trial.contacts[l].point.position;
      const Vector3 velocity = (then[l] * (now[l].inverse() * p_O) - p_O) / kStep;
      const auto i = static_cast<Eigen::Index>(l);
      EXPECT_LT(
          (torques.jacobian.block<3, 1>(3 * i, static_cast<Eigen::Index>(j)) - velocity).norm(),
          1e-6);
      const Matrix3 turn = then[l].linear() * now[l].linear().transpose();
      const Vector3 spin =
          Vector3(turn(2, 1) - turn(1, 2), turn(0, 2) - turn(2, 0), turn(1, 0) - turn(0, 1)) /
          (2.0 * kStep);
      EXPECT_NEAR(torques.spin(i, static_cast<Eigen::Index>(j)),
                  spin.dot(trial.contacts[l].point.normal), 1e-6);
    }
  }
}

}  // namespace
}  // namespace prehend
