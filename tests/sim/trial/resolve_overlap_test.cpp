// Hands that start in a small overlap: by how much they give way, and in which direction.
#include "sim/trial/resolve_overlap.h"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "sim/base/random.h"
#include "sim/shape/object_generator.h"
#include "sim/trial/candidate.h"
#include "sim/trial/run_trial.h"
#include "tests/support/scenes.h"

namespace prehend {
namespace {

using test::compiled;

// The hand's base above the object, looking down, its fingers closing along x: the inner faces of
// the open plates are at x = -40 mm and 40 mm, their tips 80 mm below the palm.
Candidate above(double x, double palm_z) {
  Candidate candidate;
  Matrix3 down;
  down << 1, 0, 0, 0, -1, 0, 0, 0, -1;
  candidate.X_OH = pose_from(down, {x, 0.0, palm_z});
  candidate.approach_O = -Vector3::UnitZ();
  candidate.preshape = 0;
  return candidate;
}

CompiledScene jaw_and_cube(std::vector<StaticBody> obstacles = {}) {
  return compiled(find_robot("parallel_jaw"), make_box({0.05, 0.03, 0.05}), std::move(obstacles));
}

void expect_no_overlap(const CompiledScene& scene, const Trial& trial) {
  EXPECT_EQ(test::collision(scene, trial.X_OH, trial.joints), "");
}

// The cube reaches to x = 25 mm, the plate begins at 24 mm.
TEST(GiveWay, AFingerInTheSideOfTheObjectMovesAside) {
  const CompiledScene scene = jaw_and_cube();
  const Trial trial = run_trial(scene, above(-0.016, 0.06));
  EXPECT_EQ(trial.outcome, Outcome::stable);
  EXPECT_NEAR(trial.overlap_shift.x(), 1e-3, 6e-5);
  EXPECT_NEAR(trial.overlap_shift.tail<2>().norm(), 0.0, 1e-12);
  expect_no_overlap(scene, trial);
}

TEST(GiveWay, APalmInTheObjectMovesBack) {
  const CompiledScene scene = jaw_and_cube();
  const Trial trial = run_trial(scene, above(0.0, 0.0235));
  EXPECT_EQ(trial.outcome, Outcome::stable);
  EXPECT_NEAR(trial.overlap_shift.z(), 1.5e-3, 6e-5);
  EXPECT_NEAR(trial.overlap_shift.head<2>().norm(), 0.0, 1e-12);
  expect_no_overlap(scene, trial);
}

// The tips are 80 mm below the palm.
TEST(GiveWay, TipsInATableMoveUpFartherThanFingersInTheObject) {
  const CompiledScene scene =
      jaw_and_cube({test::obstacle(make_box({1.0, 1.0, 0.02}), {0.0, 0.0, -0.036})});
  // The table's top is at -26 mm, 1 mm below the cube. The tips start 3 mm below it, and then stay
  // the clearance above it.
  const Trial trial = run_trial(scene, above(0.0, 0.051));
  EXPECT_EQ(trial.outcome, Outcome::stable);
  EXPECT_NEAR(trial.overlap_shift.z(), 4e-3, 2e-4);
  expect_no_overlap(scene, trial);
  const Trial deeper = run_trial(scene, above(0.0, 0.048));
  EXPECT_EQ(deeper.outcome, Outcome::hand_blocked);
  EXPECT_EQ(deeper.blocked->body, BodyId::obstacle(0));
  EXPECT_NEAR(deeper.overlap.value_or(0.0), 6e-3, 6e-5);
  // Deeper in the object than that may give way, and in the table too.
  const CompiledScene low =
      jaw_and_cube({test::obstacle(make_box({1.0, 1.0, 0.02}), {0.0, 0.0, -0.066})});
  EXPECT_EQ(run_trial(low, above(0.0, 0.0205)).outcome, Outcome::hand_blocked);
}

TEST(GiveWay, TipsThatStandOnATableMoveUpByTheClearance) {
  const CompiledScene scene =
      jaw_and_cube({test::obstacle(make_box({1.0, 1.0, 0.02}), {0.0, 0.0, -0.036})});
  const Trial trial = run_trial(scene, above(0.0, 0.054 + 2e-5));
  EXPECT_EQ(trial.outcome, Outcome::stable);
  EXPECT_NEAR(trial.overlap_shift.z(), TrialOptions{}.obstacle_clearance, 1e-12);
  TrialOptions stiff;
  stiff.resolve_overlap.obstacle = 0.0;
  EXPECT_EQ(run_trial(scene, above(0.0, 0.054 + 2e-5), stiff).outcome, Outcome::approach_blocked);
}

TEST(GiveWay, DeeperThanTheOptionIsBlockedWhereItWas) {
  const CompiledScene scene = jaw_and_cube();
  const Candidate candidate = above(-0.018, 0.06);  // 3 mm
  const Trial trial = run_trial(scene, candidate);
  EXPECT_EQ(trial.outcome, Outcome::hand_blocked);
  EXPECT_TRUE(trial.overlap_shift.isZero(0.0));
  EXPECT_EQ(trial.X_OH.matrix(), candidate.X_OH.matrix());
  EXPECT_NEAR(trial.overlap.value_or(0.0), 3e-3, 6e-5);
  TrialOptions options;
  options.resolve_overlap.deepest = 2.5e-3;
  EXPECT_FALSE(run_trial(scene, candidate, options).overlap.has_value());
  options.resolve_overlap.object = 4e-3;
  const Trial more = run_trial(scene, candidate, options);
  EXPECT_EQ(more.outcome, Outcome::stable);
  EXPECT_NEAR(more.overlap_shift.x(), 3e-3, 6e-5);
  options.resolve_overlap.object = 0.0;
  EXPECT_EQ(run_trial(scene, above(-0.016, 0.06), options).outcome, Outcome::hand_blocked);
}

TEST(GiveWay, AnObjectThatIsTooWideForTheFingersIsBlocked) {
  const CompiledScene scene = compiled(find_robot("parallel_jaw"), make_box({0.081, 0.03, 0.05}));
  EXPECT_EQ(run_trial(scene, above(0.0, 0.06)).outcome, Outcome::hand_blocked);
}

TEST(GiveWay, AHandThatTouchesNothingStays) {
  const CompiledScene scene = jaw_and_cube();
  GiveWayWorkspace workspace;
  const Candidate candidate = above(0.0, 0.06);
  const auto move = resolve_overlap(scene, candidate.X_OH, {0.04, 0.04}, {}, workspace);
  ASSERT_TRUE(move.has_value());
  EXPECT_TRUE(move->isZero(0.0));
}

// Hands at random places around a mug. What is found is free and allowed; it cannot be made much
// shorter along its own direction; and where nothing is found, no random move is free either that
// is clearly shorter than allowed, except rarely one between the directions that are looked at.
TEST(GiveWay, RandomOverlapsAreResolvedByShortMoves) {
  Random random(1404);
  const Robot hand = find_robot("franka_hand");
  const CompiledScene scene = compiled(hand, generate_object("mug", 1000));
  const std::vector<double> open = joint_values(hand, hand.hand->preshapes[0].dofs);
  const OverlapOptions options{.object = 4e-3};
  GiveWayWorkspace workspace;
  HandCollisionWorkspace collision;
  int resolved = 0;
  int missed = 0;
  int unresolved = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vector3 p = random.in_box({-0.05, -0.05, 0.04}, {0.05, 0.05, 0.1});
    const double angle = random.uniform(0.0, 3.0);
    const Matrix3 turn = Eigen::AngleAxisd(angle, random.direction()).toRotationMatrix();
    const Pose X_OH = pose_from(turn, p - turn * Vector3(0.0, 0.0, 0.1));
    const auto is_free = [&](const Vector3& by) {
      return !hand_collision(scene, translation(by) * X_OH, open, collision);
    };
    const auto move = resolve_overlap(scene, X_OH, open, options, workspace);
    if (is_free(Vector3::Zero())) {
      ASSERT_TRUE(move.has_value());
      EXPECT_TRUE(move->isZero(0.0));
    } else if (move) {
      ++resolved;
      EXPECT_TRUE(is_free(*move));
      EXPECT_LE(move->norm(), options.object + 1e-12);
      EXPECT_FALSE(is_free((move->norm() - 6e-5) * move->normalized()));
    } else {
      ++unresolved;
      bool found = false;
      for (int k = 0; k < 50; ++k)
        found = found || is_free(0.8 * options.object * random.direction());
      missed += found ? 1 : 0;
    }
  }
  EXPECT_GT(resolved, 20);
  EXPECT_GT(unresolved, 20);
  EXPECT_LE(missed, unresolved / 20);
}

}  // namespace
}  // namespace prehend
