// Trials of a hand whose finger branches, and of fingers that stand on a moving part of the hand.
#include <cmath>

#include <gtest/gtest.h>

#include "sim/base/random.h"
#include "sim/trial/candidate.h"
#include "sim/trial/close_hand.h"
#include "sim/trial/run_trial.h"
#include "sim/trial/self_centering.h"
#include "sim/trial/trial.h"
#include "tests/support/scenes.h"
#include "tests/support/trees.h"

namespace prehend {
namespace {

using test::block;

ClosedHand close_from_straight(const CompiledScene& scene) {
  ClosingStart start;
  start.dofs = std::vector<double>(5, 0.0);
  return close_hand(scene, start, test::kDefaultTrial);
}

// In the way of the upper branch only.
const Vector3 kByUpper(0.06, 0.05, 0.03);

TEST(BranchingHand, ABranchThatIsStoppedLeavesTheOtherToGoOn) {
  const CompiledScene scene =
      test::compiled(test::branching_hand(), block({0.02, 0.02, 0.02}, kByUpper));
  const ClosedHand closed = close_from_straight(scene);
  EXPECT_TRUE(closed.stopped_by_contact[0]) << "the stem moves the upper branch";
  EXPECT_TRUE(closed.stopped_by_contact[1]);
  EXPECT_FALSE(closed.stopped_by_contact[2]);
  EXPECT_LT(closed.joints[1], 1.4);
  EXPECT_DOUBLE_EQ(closed.joints[2], 1.5) << "to its limit";
  const auto gaps = test::object_gaps(scene, Pose::Identity(), closed.joints);
  EXPECT_GT(gaps[2], 0.0);
  EXPECT_LE(gaps[2], test::kDefaultTrial.closed_gap() + 1e-12);
  EXPECT_EQ(test::collision(scene, Pose::Identity(), closed.joints), "");
}

TEST(BranchingHand, BothBranchesCloseOnABarAcrossThem) {
  const CompiledScene scene =
      test::compiled(test::branching_hand(), block({0.02, 0.02, 0.12}, {0.06, 0.05, 0.0}));
  const ClosedHand closed = close_from_straight(scene);
  const auto gaps = test::object_gaps(scene, Pose::Identity(), closed.joints);
  EXPECT_TRUE(closed.stopped_by_contact[1] && closed.stopped_by_contact[2]);
  for (const std::size_t tip : {2U, 3U}) {
    EXPECT_GT(gaps[tip], 0.0);
    EXPECT_LE(gaps[tip], test::kDefaultTrial.closed_gap() + 1e-12) << scene.links[tip].name;
  }
}

// The lower branch is bent down to z = 0 on its way: it meets the upper one, which stands still.
TEST(BranchingHand, BranchesStopAtEachOther) {
  Robot hand = test::branching_hand();
  hand.joints[2].axis = Vector3(0.0, -1.0, 0.0);  // turns up, towards the upper branch
  hand.dofs[0].closing_velocity = hand.dofs[1].closing_velocity = 0.0;
  const CompiledScene scene = test::compiled(hand, block({0.02, 0.02, 0.02}, {0.0, -1.0, 0.0}));
  const ClosedHand closed = close_from_straight(scene);
  EXPECT_TRUE(closed.stopped_by_contact[2]);
  EXPECT_LT(closed.joints[2], 1.0);
  EXPECT_EQ(test::collision(scene, Pose::Identity(), closed.joints), "");
}

TEST(BranchingHand, ATrialRunsToItsEndWithoutPenetration) {
  Random random(341);
  const CompiledScene scene =
      test::compiled(test::branching_hand(), block({0.03, 0.03, 0.1}, Vector3::Zero()));
  int touched = 0;
  for (int i = 0; i < 30; ++i) {
    Candidate candidate;
    candidate.X_OH = translation(Vector3(-0.09, -0.04, 0.0) + random.in_box(0.02));
    candidate.preshape = 0;
    const Trial trial = run_trial(scene, candidate);
    if (trial.outcome == Outcome::stable || trial.outcome == Outcome::not_force_closure) ++touched;
    if (trial.joints.empty()) continue;
    EXPECT_EQ(test::collision(scene, trial.X_OH, trial.joints), "") << i;
  }
  EXPECT_GT(touched, 5);
}

// The Franka hand with a joint between its body and its fingers.
Robot turning_fingers() {
  Robot hand = find_robot("franka_hand");
  for (Joint& joint : hand.joints) {
    joint.parent = 0;
    joint.dof = 1;
    ++joint.chain;
  }
  for (Chain& chain : hand.chains) ++chain.first_joint;
  for (Link& link : hand.links) link.joint += link.joint >= 0 ? 1 : 0;
  hand.joints.insert(hand.joints.begin(),
                     {.name = "turn", .axis = Vector3(0.0, 0.6, 0.8), .lower = -1.0, .upper = 1.0});
  hand.chains.insert(hand.chains.begin(), {.name = "turn", .first_joint = 0, .joint_count = 1});
  hand.dofs.insert(hand.dofs.begin(), {.name = "turn", .lower = -1.0, .upper = 1.0});
  for (Preshape& preshape : hand.hand->preshapes) {
    preshape.dofs.insert(preshape.dofs.begin(), 0.0);
  }
  return hand;
}

TEST(SelfCentering, FingersOnAMovingPartStayWhereTheyTouch) {
  const Robot hand = turning_fingers();
  const CompiledScene scene = test::compiled(hand, make_box({0.01, 0.01, 0.01}));
  for (const double turn : {-0.3, 0.0, 0.7}) {
    Pose X_OH = translation({0.0, 0.0, -0.1});
    ClosedHand closed{{turn, 0.03}, {turn, 0.01, 0.03}, {false, true, true}};
    const auto before = test::link_poses_in_object(scene, X_OH, closed.joints);
    ASSERT_TRUE(center_hand(scene, X_OH, closed));
    EXPECT_DOUBLE_EQ(closed.joints[1], 0.02);
    const auto after = test::link_poses_in_object(scene, X_OH, closed.joints);
    for (std::size_t l = 1; l < before.size(); ++l) {
      EXPECT_TRUE(after[l].isApprox(before[l], 1e-12)) << turn << " " << scene.links[l].name;
    }
  }
}

}  // namespace
}  // namespace prehend
