// Hands with one finger that closes onto a jaw which stands still.
#include <gtest/gtest.h>

#include "sim/robot/hand/derive_hand.h"
#include "sim/robot/one_finger.h"
#include "sim/shape/basic_shapes.h"
#include "sim/trial/run_trial.h"
#include "tests/support/scenes.h"

namespace prehend {
namespace {

// A palm with a jaw that stands 25 mm beside its middle, and one that turns about y 20 mm on the
// other side of it: upright at 0, open at 1.2 rad.
Robot one_jaw() {
  Robot robot;
  robot.name = "one_jaw";
  Joint jaw;
  jaw.name = "jaw";
  jaw.X_PJ = translation(Vector3(0.02, 0.0, 0.016));
  jaw.axis = Vector3::UnitY();
  jaw.lower = -0.5;
  jaw.upper = 1.2;
  robot.joints = {jaw};
  robot.dofs = {{.name = "jaw", .lower = -0.5, .upper = 1.2}};
  robot.chains = {{.name = "jaw", .first_joint = 0, .joint_count = 1}};
  const TriangleMesh finger =
      transformed(make_box(Vector3(0.01, 0.02, 0.08)), translation(Vector3(0.0, 0.0, 0.04)));
  robot.links = {{.name = "palm",
                  .material = "plastic",
                  .joint = -1,
                  .mesh = make_box(Vector3(0.06, 0.03, 0.03))},
                 {.name = "fixed",
                  .material = "rubber",
                  .joint = -1,
                  .mesh = transformed(finger, translation(Vector3(-0.025, 0.0, 0.015)))},
                 {.name = "mover", .material = "rubber", .joint = 0, .mesh = finger}};
  return robot;
}

// Fingers that lean by less than twice the angle of friction hold what is pushed between them.
TEST(FixedJaw, HoldsWhatIsPushedAgainstIt) {
  const Robot hand = with_derived_hand(one_jaw());
  const auto pushing = pushing_direction(hand);
  ASSERT_TRUE(pushing.has_value());
  EXPECT_NEAR(pushing->dot(hand.hand->approach), 0.0, 1e-12);
  EXPECT_LT(pushing->x(), -0.8);
  const std::string& held = hand.notes.back();
  EXPECT_NE(held.find("held when closed on test bodies: sphere"), std::string::npos) << held;
  const CompiledScene scene = test::compiled(hand, make_box(Vector3(0.02, 0.02, 0.02)));
  Candidate candidate;
  candidate.X_OH = translation(Vector3(0.0, 0.0, -0.05));
  candidate.preshape = 0;
  const Trial trial = run_trial(scene, candidate);
  EXPECT_EQ(trial.outcome, Outcome::stable);
  // By this the object was pushed before it met the jaw, 15 to 20 mm beside the palm's middle.
  EXPECT_LT(trial.pushed.x(), -0.009);
  EXPECT_NEAR(trial.X_OH.translation().x() + trial.pushed.x(), 0.0, 1e-12);
  bool fixed = false;
  bool moving = false;
  for (const GraspContact& contact : trial.contacts) {
    const bool on_fixed = contact.link == link_id(1);
    (on_fixed ? fixed : moving) = true;
    EXPECT_TRUE(!on_fixed || contact.point.normal.x() > 1.0 - 1e-9);
  }
  EXPECT_TRUE(fixed && moving);
}

// Its dynamics do so where a hand closes in time.
TEST(FixedJaw, IsNotGoneToByAHandThatClosesInTime) {
  const CompiledScene scene =
      test::compiled(with_derived_hand(one_jaw()), make_box(Vector3(0.02, 0.02, 0.02)));
  Candidate candidate;
  candidate.X_OH = translation(Vector3(0.0, 0.0, -0.05));
  candidate.preshape = 0;
  TrialOptions options;
  options.formation.dynamic = true;
  const Trial trial = run_trial(scene, candidate, options);
  EXPECT_TRUE(trial.pushed.isZero(0.0));
  EXPECT_TRUE(trial.X_OC.has_value());
}

// Where the jaw is too far away, nothing is pushed.
TEST(FixedJaw, IsNotMetByWhatIsBesideTheHand) {
  const CompiledScene scene =
      test::compiled(with_derived_hand(one_jaw()), make_box(Vector3(0.02, 0.02, 0.02)));
  Candidate candidate;
  candidate.X_OH = translation(Vector3(0.1, 0.0, -0.05));
  candidate.preshape = 0;
  const Trial trial = run_trial(scene, candidate);
  EXPECT_EQ(trial.outcome, Outcome::no_contact);
  EXPECT_TRUE(trial.pushed.isZero(0.0));
}

TEST(FixedJaw, IsNoPartOfHandsWithSeveralFingers) {
  for (const char* name : {"parallel_jaw", "barrett", "robotiq_2f85", "shadow_like"}) {
    EXPECT_FALSE(pushing_direction(find_robot(name)).has_value()) << name;
  }
}

}  // namespace
}  // namespace prehend
