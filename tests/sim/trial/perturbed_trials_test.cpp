// Errors of pose, friction and centre of mass, and what they do to a grasp.
#include "sim/trial/perturbed_trials.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "sim/base/gravity.h"
#include "sim/scene/object_mass.h"
#include "sim/trial/payload_margin.h"
#include "sim/trial/run_trial.h"
#include "sim/trial/uncertainty.h"
#include "tests/support/scenes.h"

namespace prehend {
namespace {

// The parallel jaw 80 mm open, over a block of this width along its closing direction x; the
// block's length along y is what the plates, 40 mm wide, may be off by.
CompiledScene block_scene(double width, double length) {
  return test::compiled(find_robot("parallel_jaw"), make_box({width, length, 0.05}));
}

struct Tried {
  Candidate candidate;
  Trial trial;
};

// From above, the palm 60 mm above the middle of the block, which then is between the plates.
Tried grasp_from_above(const CompiledScene& scene) {
  Candidate candidate;
  Matrix3 down;
  down << 1, 0, 0, 0, -1, 0, 0, 0, -1;
  candidate.X_OH = pose_from(down, {0.0, 0.0, 0.06});
  candidate.approach_O = -Vector3::UnitZ();
  candidate.approach_distance = 0.1;
  candidate.preshape = 0;
  Tried tried{candidate, run_trial(scene, candidate)};
  EXPECT_EQ(tried.trial.outcome, Outcome::stable);
  return tried;
}

Robustness robustness_of(const CompiledScene& scene, const Tried& tried,
                         const UncertaintyOptions& options) {
  TrialWorkspace workspace;
  return try_perturbed(scene, tried.candidate, tried.trial, {}, perturbations(scene, options, 1),
                       workspace);
}

constexpr UncertaintyOptions kNone = {.across = 0.0,
                                      .along = 0.0,
                                      .angle = 0.0,
                                      .hand = 0.0,
                                      .hand_angle = 0.0,
                                      .friction = 0.0,
                                      .center_of_mass = 0.0};

TEST(Disturbances, HaveTheStatedDeviations) {
  Scene scene = test::scene_with(find_robot("parallel_jaw"), make_box({0.04, 0.06, 0.08}));
  scene.object.X_WO = Pose(Eigen::AngleAxisd(0.5 * std::numbers::pi, Vector3::UnitX()));
  const CompiledScene compiled = compile(std::move(scene));
  const UncertaintyOptions options{.samples = 4096,
                                   .across = 3e-3,
                                   .along = 1e-3,
                                   .angle = 0.05,
                                   .hand = 0.0,
                                   .hand_angle = 0.0,
                                   .friction = 0.2,
                                   .center_of_mass = 0.1};
  Vector3 shift2 = Vector3::Zero();
  Vector3 center2 = Vector3::Zero();
  double angle2 = 0.0;
  double friction2 = 0.0;
  double friction1 = 0.0;
  for (const Perturbation& one : perturbations(compiled, options, 7)) {
    shift2 += one.X_OC.translation().cwiseAbs2() / options.samples;
    center2 += one.center_of_mass_O.cwiseAbs2() / options.samples;
    const double angle = Eigen::AngleAxisd(one.X_OC.linear()).angle();
    angle2 += angle * angle / options.samples;
    friction1 += std::log(one.friction) / options.samples;
    friction2 += std::log(one.friction) * std::log(one.friction) / options.samples;
  }
  // Gravity is along the object's y.
  EXPECT_NEAR(std::sqrt(shift2.x()), 3e-3, 1e-4);
  EXPECT_NEAR(std::sqrt(shift2.y()), 1e-3, 3e-5);
  EXPECT_NEAR(std::sqrt(shift2.z()), 3e-3, 1e-4);
  EXPECT_NEAR(std::sqrt(angle2), 0.05 * std::sqrt(3.0), 3e-3);
  EXPECT_NEAR(friction1, 0.0, 0.01);
  EXPECT_NEAR(std::sqrt(friction2), 0.2, 0.01);
  const double size = 0.1 / compiled.wrench_frame.torque_scale;
  EXPECT_NEAR((center2.cwiseSqrt() - Vector3::Constant(size)).norm(), 0.0, 0.1 * size);
}

// The root of the mean square of the shift of the centre of mass along each axis, as a part of the
// object's largest distance from it.
Vector3 center_deviation(const CompiledScene& scene) {
  const UncertaintyOptions options{.samples = 4096, .center_of_mass = 0.1};
  Vector3 squares = Vector3::Zero();
  for (const Perturbation& one : perturbations(scene, options, 7)) {
    squares += one.center_of_mass_O.cwiseAbs2() / options.samples;
  }
  return scene.wrench_frame.torque_scale * squares.cwiseSqrt();
}

TEST(Disturbances, OfACentreOfMassDependOnWhatIsKnownOfIt) {
  Scene scene = test::scene_with(find_robot("parallel_jaw"), make_box({0.04, 0.06, 0.3}));
  EXPECT_LT((center_deviation(compile(scene)) - Vector3(0.1, 0.1, 0.3)).norm(), 0.03);
  state_center_of_mass(scene.object, {0.0, 0.0, 0.1});
  EXPECT_LT((center_deviation(compile(scene)) - Vector3::Constant(0.025)).norm(), 0.003);
  const MassPart head{.where = BeyondPlane{}, .density = 8000.0};
  state_mass(scene.object, {.density = 700.0, .parts = {head}});
  EXPECT_LT((center_deviation(compile(scene)) - Vector3::Constant(0.025)).norm(), 0.003);
  // Materials that a file names are a better guess than none, but one.
  scene.object.mass_basis = MassBasis::materials;
  EXPECT_LT((center_deviation(compile(scene)) - Vector3::Constant(0.1)).norm(), 0.012);
}

TEST(Disturbances, TheFirstDoNotDependOnHowManyThereAre) {
  const CompiledScene scene = block_scene(0.04, 0.03);
  const auto few = perturbations(scene, {.samples = 5}, 3);
  const auto many = perturbations(scene, {.samples = 50}, 3);
  const auto others = perturbations(scene, {.samples = 5}, 4);
  for (std::size_t i = 0; i < few.size(); ++i) {
    EXPECT_EQ(few[i].X_OC.matrix(), many[i].X_OC.matrix());
    EXPECT_EQ(few[i].friction, many[i].friction);
    EXPECT_NE(few[i].friction, others[i].friction);
  }
}

TEST(HeldInterval, ContainsTheShareAndShrinks) {
  for (const int n : {1, 4, 16, 64}) {
    for (int k = 0; k <= n; ++k) {
      const Interval interval = held_interval(k, n);
      EXPECT_LE(interval.lower, static_cast<double>(k) / n + 1e-12);
      EXPECT_GE(interval.upper, static_cast<double>(k) / n - 1e-12);
      EXPECT_GE(interval.lower, 0.0);
      EXPECT_LE(interval.upper, 1.0);
    }
  }
  EXPECT_LT(held_interval(32, 64).upper - held_interval(32, 64).lower,
            held_interval(8, 16).upper - held_interval(8, 16).lower);
  // By Wilson's formula: (0.5 + z^2 / 32 -+ z sqrt(1 / 64 + z^2 / 1024)) / (1 + z^2 / 16).
  EXPECT_NEAR(held_interval(8, 16).lower, 0.3098, 1e-3);
  EXPECT_EQ(held_interval(0, 0).upper, 1.0);
}

// Without any error each sample is the trial itself.
TEST(TryDisturbed, WithoutErrorsRepeatsTheTrial) {
  const CompiledScene scene = block_scene(0.04, 0.03);
  const Tried tried = grasp_from_above(scene);
  const Robustness robustness = robustness_of(scene, tried, kNone);
  EXPECT_EQ(robustness.samples, 16);
  EXPECT_EQ(robustness.held, 16);
  EXPECT_EQ(robustness.outcomes[Outcome::stable], 16);
  EXPECT_NEAR(robustness.epsilon_mean, tried.trial.epsilon.lower, 1e-9);
  EXPECT_NEAR(robustness.epsilon_low, tried.trial.epsilon.lower, 1e-9);
}

// The plates are 80 mm apart: a block of 77.6 mm may be off by 1.2 mm to either side, one of 59 mm
// by more than 10 mm.
TEST(TryDisturbed, FindsHowFarTheObjectMayBeOff) {
  const auto position_margin = [](double width) {
    const CompiledScene scene = block_scene(width, 0.03);
    const Robustness robustness = robustness_of(scene, grasp_from_above(scene), kNone);
    if (robustness.position_margin < kMarginSteps.back()) {
      EXPECT_NEAR(std::abs(robustness.weakest_O.x()), 1.0, 1e-9);
    }
    return robustness.position_margin;
  };
  EXPECT_EQ(position_margin(0.0776), 1e-3);
  EXPECT_EQ(position_margin(0.0696), 5e-3);
  EXPECT_EQ(position_margin(0.059), 1e-2);
}

// Of two blocks that are held equally well the one with more room on both sides is held in more of
// the samples.
TEST(TryDisturbed, MoreToSpareHoldsInMoreSamples) {
  UncertaintyOptions options = kNone;
  options.samples = 64;
  options.across = 5e-3;
  const CompiledScene tight = block_scene(0.0776, 0.03);
  const CompiledScene roomy = block_scene(0.0696, 0.03);
  const Robustness one = robustness_of(tight, grasp_from_above(tight), options);
  const Robustness five = robustness_of(roomy, grasp_from_above(roomy), options);
  EXPECT_GT(five.held, one.held + 10);
  EXPECT_LT(five.held, 64);
}

// Where the object is thought to be, a plate overlaps the block by 3.8 mm. With normal errors of 5
// mm it fits between the plates where these are between 3.8 and 14.2 mm: in 22 % of all cases. The
// grasp states no approach, so the hand comes from above by itself.
TEST(TryDisturbed, WhatTheObjectBlocksMayHoldWithErrors) {
  const CompiledScene scene = block_scene(0.0696, 0.03);
  Tried tried = grasp_from_above(scene);
  tried.candidate.X_OH.translation().x() = 0.009;
  tried.candidate.approach_distance = 0.0;
  tried.trial = run_trial(scene, tried.candidate);
  ASSERT_EQ(tried.trial.outcome, Outcome::hand_blocked);
  EXPECT_EQ(robustness_of(scene, tried, kNone).held, 0);
  UncertaintyOptions options = kNone;
  options.samples = 256;
  options.across = 5e-3;
  const Robustness robustness = robustness_of(scene, tried, options);
  EXPECT_NEAR(robustness.held, 0.221 * 256, 13);
  // In the first sample that closes, the plates do so on the block's upper face.
  EXPECT_EQ(robustness.strength, 0.0);
  ASSERT_TRUE(robustness.free);
  EXPECT_FALSE(robustness.free->kept);
  EXPECT_EQ(robustness.position_margin, 0.0);
}

// Put between the plates without an approach, a block is missed by a hand that is blocked: it does
// not stop above it and close there instead.
TEST(TryDisturbed, WhatIsPutToItsPlaceIsPutThereAgain) {
  const CompiledScene scene = block_scene(0.0776, 0.03);
  Tried tried = grasp_from_above(scene);
  tried.candidate.approach_distance = 0.0;
  tried.trial = run_trial(scene, tried.candidate);
  ASSERT_EQ(tried.trial.outcome, Outcome::stable);
  UncertaintyOptions options = kNone;
  options.samples = 64;
  options.across = 1e-2;
  const Robustness robustness = robustness_of(scene, tried, options);
  EXPECT_EQ(robustness.closed() + robustness.outcomes[Outcome::hand_blocked] +
                robustness.outcomes[Outcome::no_contact],
            64);
  EXPECT_GT(robustness.outcomes[Outcome::hand_blocked], 32);
}

// Larger errors of the pose do not hold more often, nor do more slippery or heavier objects.
TEST(TryDisturbed, LargerErrorsHoldLess) {
  const CompiledScene scene = block_scene(0.0696, 0.03);
  const Tried tried = grasp_from_above(scene);
  int before = 65;
  for (const double across : {0.0, 2e-3, 5e-3, 1e-2, 2e-2}) {
    UncertaintyOptions options = kNone;
    options.samples = 64;
    options.across = across;
    const int held = robustness_of(scene, tried, options).held;
    EXPECT_LE(held, before);
    before = held;
  }
  EXPECT_LT(before, 32);
}

// The weight is at the limit of a finger: samples with less friction drop it.
TEST(TryDisturbed, ErrorsOfFrictionDropWhatIsHeldBarely) {
  Scene scene = test::scene_with(find_robot("franka_hand"), make_box({0.012, 0.12, 0.02}));
  scene.friction.set(Material::rubber, Material::plastic, 0.6);
  scene.object.mass = 0.999 * 2.0 * 70.0 * 0.6 / kStandardGravity;
  const CompiledScene compiled = compile(std::move(scene));
  Tried tried;
  const double reach = compiled.scene.hand.hand->origin.z() + 0.0373;
  tried.candidate.X_OH = translation({0.0, 0.0, -reach});
  tried.candidate.preshape = 0;
  tried.trial = run_trial(compiled, tried.candidate);
  ASSERT_EQ(tried.trial.outcome, Outcome::stable);
  EXPECT_EQ(robustness_of(compiled, tried, kNone).held, 16);
  UncertaintyOptions options = kNone;
  options.samples = 64;
  options.friction = 0.25;
  EXPECT_NEAR(robustness_of(compiled, tried, options).held, 32, 8);
  // A deviation of the pair takes the place of the one of the options.
  for (const double deviation : {0.0, 0.25}) {
    Scene known = compiled.scene;
    known.friction_deviations.set(Material::rubber, Material::plastic, deviation);
    const CompiledScene of_pair = compile(std::move(known));
    tried.trial = run_trial(of_pair, tried.candidate);
    options.friction = deviation == 0.0 ? 0.25 : 0.0;
    EXPECT_NEAR(robustness_of(of_pair, tried, options).held, deviation == 0.0 ? 64 : 32,
                deviation == 0.0 ? 0 : 8);
  }
}

}  // namespace
}  // namespace prehend
