// A hand with coupled fingers takes an off-centre object to its middle.
#include "sim/trial/self_centering.h"

#include <cmath>

#include <gtest/gtest.h>

#include "sim/base/random.h"
#include "sim/trial/candidate.h"
#include "sim/trial/run_trial.h"
#include "sim/trial/trial.h"
#include "tests/support/scenes.h"

namespace prehend {
namespace {

// Pads meet 50 mm or so in front of the aimed point, the box is `off` aside along closing.
Candidate beside(const Robot& hand, const Vector3& off) {
  Candidate candidate;
  candidate.X_OH = translation(off - Vector3(0.0, 0.0, hand.hand->origin.z() + 0.0373));
  candidate.preshape = 0;
  return candidate;
}

TEST(SelfCentering, EndsWithEqualJointsAndBothPadsOnTheBox) {
  const Robot hand = find_robot("franka_hand");
  const CompiledScene scene = test::compiled(hand, make_box({0.03, 0.03, 0.03}));
  for (const double off : {-0.013, -0.004, 0.0, 1e-4, 0.011, 0.0145}) {
    const Candidate candidate = beside(hand, off * hand.hand->closing);
    const Trial trial = run_trial(scene, candidate);
    ASSERT_EQ(trial.outcome, Outcome::stable) << off;
    EXPECT_EQ(trial.joints[0], trial.joints[1]);
    EXPECT_EQ(trial.dofs[0], trial.joints[0]);
    // Half the box and the gap of each pad.
    EXPECT_NEAR(trial.joints[0], 0.015 + test::kDefaultTrial.contact_gap,
                0.1 * test::kDefaultTrial.contact_gap + 1e-12);
    EXPECT_LT(std::abs(trial.X_OH.translation().x()), 1e-5) << off;
    EXPECT_EQ(test::collision(scene, trial.X_OH, trial.joints), "");
    const auto gaps = test::object_gaps(scene, trial.X_OH, trial.joints);
    for (const std::size_t pad : {2U, 4U}) {
      EXPECT_GT(gaps[pad], 0.0);
      EXPECT_LE(gaps[pad], 1e-4) << scene.links[pad].name;
    }
  }
}

TEST(SelfCentering, FingersStayWhereTheyTouch) {
  Random random(111);
  const Robot hand = find_robot("franka_hand");
  const CompiledScene scene = test::compiled(hand, make_sphere(0.02, 2));
  for (int i = 0; i < 20; ++i) {
    Pose X_OH = beside(hand, random.in_box(0.008)).X_OH;
    ClosingStart start;
    start.X_OH = X_OH;
    start.dofs = {0.04};
    ClosedHand closed = close_hand(scene, start, test::kDefaultTrial);
    const auto before = test::link_poses_in_object(scene, X_OH, closed.joints);
    ASSERT_TRUE(center_hand(scene, X_OH, closed));
    const auto after = test::link_poses_in_object(scene, X_OH, closed.joints);
    for (std::size_t l = 1; l < before.size(); ++l) {
      EXPECT_TRUE(after[l].isApprox(before[l], 1e-12)) << scene.links[l].name;
    }
    EXPECT_FALSE(center_hand(scene, X_OH, closed)) << "it is in the middle already";
  }
}

TEST(SelfCentering, LeavesOtherHandsAndFreeFingersAlone) {
  for (const char* name : {"parallel_jaw", "franka_hand"}) {
    const Robot hand = find_robot(name);
    const CompiledScene scene = test::compiled(hand, make_box({0.03, 0.03, 0.03}));
    Pose X_OH = translation({0.01, 0.0, -0.06});
    const Pose X_before = X_OH;
    ClosedHand closed{std::vector<double>(hand.dofs.size(), 0.01), {0.01, 0.02}, {false, false}};
    if (hand.dofs[0].coupling != Coupling::self_centering) closed.stopped_by_contact = {true, true};
    EXPECT_FALSE(center_hand(scene, X_OH, closed)) << name;
    EXPECT_TRUE(X_OH.isApprox(X_before, 0.0));
    EXPECT_EQ(closed.joints, (std::vector<double>{0.01, 0.02}));
  }
}

// A thin plate far from the middle between the fingers: the farther one crosses the middle, which
// only the hand's own motion makes possible.
TEST(SelfCentering, TakesAPlateBeyondTheMiddleOfItsFingers) {
  const Robot hand = find_robot("franka_hand");
  const CompiledScene scene = test::compiled(hand, make_box({0.004, 0.03, 0.03}));
  for (const double off : {-0.035, -0.02, 0.03}) {
    const Trial trial = run_trial(scene, beside(hand, off * hand.hand->closing));
    ASSERT_EQ(trial.outcome, Outcome::stable) << off;
    EXPECT_EQ(trial.joints[0], trial.joints[1]);
    EXPECT_NEAR(trial.joints[0], 0.002 + test::kDefaultTrial.contact_gap,
                0.1 * test::kDefaultTrial.contact_gap + 1e-12);
    EXPECT_EQ(test::collision(scene, trial.X_OH, trial.joints), "");
  }
}

// The hand's body moves sideways without looking; what it ends on or in blocks it.
TEST(SelfCentering, TheBodyIsBlockedByWhatStandsWhereItIsPushed) {
  const Robot hand = find_robot("franka_hand");
  const TriangleMesh box = make_box({0.03, 0.03, 0.03});
  const Candidate candidate = beside(hand, -0.013 * hand.hand->closing);
  const double end_of_body = bounds(hand.links[0].mesh).upper.x();
  const double beside_body = candidate.X_OH.translation().x() + end_of_body;
  const double height = candidate.X_OH.translation().z() + 0.04;
  for (const double size : {0.002, 0.03}) {
    const Vector3 at(beside_body + 0.5 * size + 0.003, 0.0, height);
    const CompiledScene scene =
        test::compiled(hand, box, {test::obstacle(make_box(Vector3::Constant(size)), at)});
    ASSERT_EQ(test::collision(scene, candidate.X_OH, {0.04, 0.04}), "");
    const Trial trial = run_trial(scene, candidate);
    EXPECT_EQ(trial.outcome, Outcome::hand_blocked) << size;
    ASSERT_TRUE(trial.blocked.has_value());
    EXPECT_EQ(trial.blocked->link, LinkId{0});
    EXPECT_EQ(trial.blocked->body, BodyId::obstacle(0));
  }
}

}  // namespace
}  // namespace prehend
