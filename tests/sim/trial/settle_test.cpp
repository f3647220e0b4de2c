// A free object turns between two fingers until they hold it.
#include "sim/trial/settle.h"

#include <gtest/gtest.h>

#include "tests/support/scenes.h"

namespace prehend {
namespace {

// The Franka hand over a bar along y, 12 mm thick along the closing direction, turned by `angle`
// about the approach.
Trial grasp_tilted_bar(double angle, const TrialOptions& options,
                       std::vector<StaticBody> obstacles = {}) {
  const Robot hand = find_robot("franka_hand");
  const CompiledScene scene =
      test::compiled(hand, make_box({0.012, 0.12, 0.02}), std::move(obstacles));
  Candidate candidate;
  candidate.X_OH = translation({0.0, 0.0, -hand.hand->origin.z() - 0.0373});
  candidate.X_OH.rotate(Eigen::AngleAxisd(angle, Vector3::UnitZ()));
  candidate.preshape = 0;
  return run_trial(scene, candidate, options);
}

TrialOptions hard() {
  TrialOptions options;
  options.soft_fingers = false;
  return options;
}

TEST(Settle, ATiltedBarTurnsUntilItIsHeld) {
  for (const double angle : {-0.9, 0.9, 1.1}) {
    TrialOptions stiff = hard();
    stiff.settle_steps = 0;
    ASSERT_EQ(grasp_tilted_bar(angle, stiff).outcome, Outcome::not_force_closure) << angle;
    const Trial trial = grasp_tilted_bar(angle, hard());
    EXPECT_EQ(trial.outcome, Outcome::stable) << angle;
    EXPECT_GT(trial.turned, 0.0);
    // Towards the bar's faces, not away from them.
    const Vector3 closing = trial.X_OH.linear() * Vector3::UnitX();
    EXPECT_GT(std::abs(closing.x()), std::cos(std::abs(angle)));
  }
}

TEST(Settle, WhatHoldsIsLeftAlone) {
  const Trial trial = grasp_tilted_bar(0.0, hard());
  EXPECT_EQ(trial.outcome, Outcome::stable);
  EXPECT_EQ(trial.turned, 0.0);
}

TEST(Settle, AmongObstaclesNothingTurns) {
  const Trial trial = grasp_tilted_bar(
      0.9, hard(), {test::obstacle(make_box(Vector3::Constant(0.01)), {0.5, 0.5, 0.5})});
  EXPECT_EQ(trial.outcome, Outcome::not_force_closure);
  EXPECT_EQ(trial.turned, 0.0);
}

}  // namespace
}  // namespace prehend
