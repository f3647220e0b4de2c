// A free object turns and slides between two fingers until they hold it.
#include "sim/trial/settle.h"

#include <gtest/gtest.h>

#include "sim/base/random.h"
#include "sim/trial/candidate.h"
#include "sim/trial/run_trial.h"
#include "tests/support/scenes.h"
#include "tests/support/trial_bytes.h"

namespace prehend {
namespace {

// The base of the Franka hand over a bar along y, turned by `angle` about the approach.
Pose tilted_hand(double angle) {
  const Robot hand = find_robot("franka_hand");
  Pose X_OH = translation({0.0, 0.0, -hand.hand->origin.z() - 0.0373});
  X_OH.rotate(Eigen::AngleAxisd(angle, Vector3::UnitZ()));
  return X_OH;
}

Candidate over_bar(double angle) {
  Candidate candidate;
  candidate.X_OH = tilted_hand(angle);
  candidate.preshape = 0;
  return candidate;
}

// The bar is 12 mm thick along the closing direction.
CompiledScene bar_scene(std::vector<StaticBody> obstacles) {
  return test::compiled(find_robot("franka_hand"), make_box({0.012, 0.12, 0.02}),
                        std::move(obstacles));
}

Trial grasp_tilted_bar(double angle, const TrialOptions& options,
                       std::vector<StaticBody> obstacles = {}) {
  return run_trial(bar_scene(std::move(obstacles)), over_bar(angle), options);
}

TrialOptions hard() {
  TrialOptions options;
  options.contacts = ContactKind::hard;
  return options;
}

TEST(Settle, ATiltedBarTurnsUntilItIsHeld) {
  for (const double angle : {-0.9, 0.9, 1.1}) {
    TrialOptions stiff = hard();
    stiff.settle.steps = 0;
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

// A bar along y, 12 mm thick, which gets five times as thick over the 14 mm from y = 0 to its end.
TriangleMesh flared_bar() {
  TriangleMesh mesh = test::block({0.012, 0.05, 0.02}, {0.0, 0.025, 0.0});
  TriangleMesh flare = test::block({0.012, 0.014, 0.02}, {0.0, -0.007, 0.0});
  for (Vector3& v : flare.vertices) {
    if (v.y() < -0.007) v.x() *= 5.0;
  }
  append(mesh, flare);
  return mesh;
}

// The pads, 20 mm wide, touch the flare with one edge, which is too steep for friction: the bar
// slides along them until they lie on its parallel sides.
TEST(Settle, AFlaredBarSlidesUntilItIsHeld) {
  const CompiledScene scene = test::compiled(find_robot("franka_hand"), flared_bar());
  Candidate candidate = over_bar(0.0);
  candidate.X_OH.translation().y() = 0.005;
  TrialOptions stiff = hard();
  stiff.settle.steps = 0;
  ASSERT_EQ(run_trial(scene, candidate, stiff).outcome, Outcome::not_force_closure);
  const Trial trial = run_trial(scene, candidate, hard());
  ASSERT_EQ(trial.outcome, Outcome::stable);
  EXPECT_NEAR(trial.slid, 0.005, 2e-3);
  EXPECT_NEAR(trial.turned, 0.0, 1e-3);
  for (const GraspContact& contact : trial.contacts) {
    EXPECT_NEAR(std::abs(contact.point.normal.x()), 1.0, 1e-6);
  }
}

constexpr double kTilts[] = {-0.9, 0.9, 1.1};

StaticBody box_at(const Vector3& size, const Vector3& p_W) {
  return test::obstacle(make_box(size), p_W);
}

// The hand comes from below, along z: what the bar could stand on is above it.
StaticBody board_beyond_bar(double gap) {
  return box_at({1.0, 1.0, 0.02}, {0.0, 0.0, 0.01 + gap + 0.01});
}

void expect_turns_as_without(const StaticBody& obstacle, double tilt) {
  const Trial free = grasp_tilted_bar(tilt, hard());
  ASSERT_GT(free.turned, 0.0);
  EXPECT_EQ(test::bytes_of(grasp_tilted_bar(tilt, hard(), {obstacle})), test::bytes_of(free));
}

void expect_stays(const StaticBody& obstacle, double tilt) {
  TrialOptions stiff = hard();
  stiff.settle.steps = 0;
  const Trial still = grasp_tilted_bar(tilt, stiff, {obstacle});
  ASSERT_EQ(still.outcome, Outcome::not_force_closure) << "the obstacle stops the hand itself";
  EXPECT_EQ(test::bytes_of(grasp_tilted_bar(tilt, hard(), {obstacle})), test::bytes_of(still));
}

TEST(Settle, ObstaclesOutOfReachChangeNothing) {
  for (const double tilt : kTilts) {
    expect_turns_as_without(box_at({4.0, 4.0, 0.02}, {0.0, 0.0, -1.0}), tilt);
    expect_turns_as_without(box_at({4.0, 4.0, 0.02}, {0.0, 0.0, 1.0}), tilt);
    expect_turns_as_without(box_at(Vector3::Constant(0.01), {0.5, 0.5, 0.5}), tilt);
    // Farther than the bar or the hand reaches when it turns.
    expect_turns_as_without(board_beyond_bar(0.15), tilt);
  }
}

TEST(Settle, WhatStandsOnSomethingDoesNotTurn) {
  for (const double tilt : kTilts) {
    expect_stays(board_beyond_bar(0.00001), tilt);
    expect_stays(board_beyond_bar(0.0001), tilt);
  }
}

// The bar's ends would sweep to where the wall is; it is beside the bar's end, which the hand does
// not come near.
TEST(Settle, AWallInTheWayOfTheObjectKeepsItFromTurning) {
  for (const double tilt : kTilts) {
    const double side = tilt > 0.0 ? 1.0 : -1.0;
    expect_stays(box_at({0.006, 0.01, 0.02}, {-0.012 * side, 0.055, 0.0}), tilt);
  }
}

// On the other side of the bar's end the wall is only close. The bar turns to where it would
// without it, unless no step is small enough to be proven free.
TEST(Settle, AWallFromWhichTheObjectTurnsAwayChangesNothingElse) {
  int turned = 0;
  for (const double tilt : kTilts) {
    const double side = tilt > 0.0 ? 1.0 : -1.0;
    const StaticBody wall = box_at({0.006, 0.01, 0.02}, {0.012 * side, 0.055, 0.0});
    const Trial trial = grasp_tilted_bar(tilt, hard(), {wall});
    if (trial.outcome == Outcome::stable) {
      ++turned;
      const Pose X_OH = grasp_tilted_bar(tilt, hard()).X_OH;
      EXPECT_TRUE(trial.X_OH.isApprox(X_OH, 1e-3));
    } else {
      EXPECT_EQ(trial.turned, 0.0);
    }
  }
  EXPECT_GT(turned, 0);
}

// Two posts beside the hand's body, which is far from the bar.
TEST(Settle, AWallInTheWayOfTheHandKeepsTheObjectFromTurning) {
  for (const double tilt : kTilts) {
    TriangleMesh posts;
    for (const double side : {-1.0, 1.0}) {
      append(posts,
             transformed(make_box({0.01, 0.01, 0.02}), translation({0.09, side * 0.045, 0.0})));
    }
    StaticBody body = test::obstacle(std::move(posts), Vector3::Zero());
    body.X_WB = tilted_hand(tilt) * translation({0.0, 0.0, 0.03});
    expect_stays(body, tilt);
  }
}

// Boxes all around: whatever settles is free with the hand turned about the bar, and with the bar
// turned the other way in the hand at rest.
TEST(Settle, WhatTurnedIsFreeOfObstacles) {
  Random random(131);
  int turned = 0;
  int kept = 0;
  for (int i = 0; i < 150; ++i) {
    StaticBody body = box_at(Vector3::Constant(0.02), Vector3::Zero());
    const Matrix3 turn = random.rotation();
    body.X_WB = pose_from(turn, random.vector(0.05, 0.25));
    const Vector3 p = body.X_WB.translation().cwiseAbs() - Vector3(0.006, 0.06, 0.01);
    if (p.cwiseMax(0.0).norm() < 0.018) continue;  // the ball around the box could reach the bar
    const CompiledScene scene = bar_scene({body});
    TrialOptions stiff = hard();
    stiff.settle.steps = 0;
    const Trial still = run_trial(scene, over_bar(0.9), stiff);
    if (still.outcome != Outcome::not_force_closure) continue;
    const Trial trial = run_trial(scene, over_bar(0.9), hard());
    EXPECT_EQ(test::collision(scene, trial.X_OH, trial.joints), "");
    if (trial.turned == 0.0) {
      ++kept;
      continue;
    }
    ++turned;
    const Pose X_SO = still.X_OH * trial.X_OH.inverse();
    const auto moved = test::soup(scene.object().mesh.mesh(), X_SO);
    const auto box = test::soup(scene.obstacles()[0].mesh.mesh(), scene.obstacles()[0].X_RB);
    EXPECT_FALSE(test::surfaces_meet(moved, box));
  }
  EXPECT_GT(turned, 20);
  EXPECT_GT(kept, 5);
}

}  // namespace
}  // namespace prehend
