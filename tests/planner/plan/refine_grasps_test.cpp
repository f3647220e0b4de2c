#include "planner/plan/refine_grasps.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "planner/plan/grasp_moves.h"
#include "planner/plan/propose/candidates.h"
#include "primitives/decompose.h"
#include "sim/base/input_error.h"
#include "sim/base/random.h"
#include "sim/quality/wrench_space.h"
#include "sim/trial/grasp_contacts.h"
#include "sim/trial/run_trial.h"
#include "tests/support/library_scenes.h"
#include "tests/support/scenes.h"
#include "tests/support/trial_bytes.h"

namespace prehend {
namespace {

const CompiledScene& mug_to_refine() {
  static const CompiledScene scene = test::compiled_library_scene("mug");
  return scene;
}

// The best `count` of 100 candidates for the mug, best first.
std::vector<TriedGrasp> best_of_mug(std::size_t count) {
  const CompiledScene& scene = mug_to_refine();
  static const std::vector<TriedGrasp> all = [&] {
    std::vector<TriedGrasp> grasps;
    for (const ProposedGrasp& grasp :
         propose_grasps(scene, decompose(scene.scene.object.mesh).primitives, 100).grasps) {
      Trial trial = run_trial(scene, grasp.candidate);
      if (trial.outcome == Outcome::stable) grasps.push_back({grasp.candidate, trial});
    }
    std::stable_sort(grasps.begin(), grasps.end(), [](const auto& a, const auto& b) {
      return a.trial.epsilon.lower > b.trial.epsilon.lower;
    });
    return grasps;
  }();
  EXPECT_GE(all.size(), count);
  return {all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count)};
}

RefineOptions few_trials(int trials) {
  RefineOptions options;
  options.trials = trials;
  return options;
}

TEST(RefineGrasps, EachIsBetterThanItsParentAndAsItsTrialSays) {
  const CompiledScene& scene = mug_to_refine();
  const std::vector<TriedGrasp> parents = best_of_mug(4);
  const std::vector<RefinedGrasp> refined = refine_grasps(scene, parents, {}, few_trials(100));
  ASSERT_FALSE(refined.empty());
  int last = -1;
  for (const RefinedGrasp& grasp : refined) {
    EXPECT_GT(grasp.parent, last);  // one each, in their order
    last = grasp.parent;
    ASSERT_LT(grasp.parent, 4);
    const Trial& parent = parents[static_cast<std::size_t>(grasp.parent)].trial;
    EXPECT_EQ(grasp.trial.outcome, Outcome::stable);
    EXPECT_EQ(grasp.trial.back_offs, 0);
    EXPECT_GT(grasp.gain, 0.0);
    EXPECT_EQ(grasp.trial.epsilon.lower - parent.epsilon.lower, grasp.gain);
    // Tried again with all options, the candidate gives the same trial.
    const Trial again = run_trial(scene, grasp.candidate);
    EXPECT_EQ(test::bytes_of(again), test::bytes_of(grasp.trial));
  }
}

TEST(RefineGrasps, ContactsTouchAndNothingPenetrates) {
  const CompiledScene& scene = mug_to_refine();
  const TrialOptions options;
  for (const RefinedGrasp& grasp : refine_grasps(scene, best_of_mug(2), options, few_trials(60))) {
    EXPECT_EQ(test::collision(scene, grasp.trial.X_OH, grasp.trial.joints), "");
    for (const GraspContact& contact : grasp.trial.contacts) {
      EXPECT_GT(contact.gap, 0.0);
      EXPECT_LE(contact.gap, options.contact.threshold);
    }
    const Matrix3 R_OH = grasp.candidate.X_OH.linear();
    EXPECT_LT((R_OH.transpose() * R_OH - Matrix3::Identity()).norm(), 1e-12);
    EXPECT_LT((R_OH * scene.scene.hand.hand->approach - grasp.candidate.approach_O).norm(), 1e-12);
  }
}

// Every bit of every number is the same, and so is the list of what was tried.
TEST(RefineGrasps, SameBytesOnOneAndTwoThreads) {
  const std::vector<TriedGrasp> parents = best_of_mug(3);
  const auto refined_on = [&](int threads, const RefineOptions& options) {
    std::vector<unsigned char> bytes;
    for (const RefinedGrasp& grasp :
         refine_grasps(mug_to_refine(), parents, {}, options, RunContext{.threads = threads})) {
      const std::vector<unsigned char> trial = test::bytes_of(grasp.trial);
      bytes.insert(bytes.end(), trial.begin(), trial.end());
      test::append_bytes(bytes, grasp.candidate.X_OH.data(), 16 * sizeof(double));
      test::append_bytes(bytes, &grasp.gain, sizeof(double));
      test::append_bytes(bytes, &grasp.parent, sizeof(int));
      test::append_bytes(bytes, &grasp.trials_used, sizeof(int));
    }
    return bytes;
  };
  RefineOptions robust = few_trials(24);
  robust.objective = RefineObjective::robust;
  robust.noise.samples = 10;
  for (const RefineOptions& options : {few_trials(60), robust}) {
    const std::vector<unsigned char> one = refined_on(1, options);
    EXPECT_FALSE(one.empty());
    EXPECT_EQ(one, refined_on(2, options));
  }
}

TEST(RefineGrasps, TheRobustObjectiveIsRaised) {
  const CompiledScene& scene = mug_to_refine();
  const std::vector<TriedGrasp> parents = best_of_mug(2);
  RefineOptions options = few_trials(40);
  options.objective = RefineObjective::robust;
  options.noise.samples = 20;
  const auto robust = [&](const Trial& trial) {
    return robust_epsilon(contacts_of(trial.contacts), scene.wrench_frame, {}, options.noise).mean;
  };
  for (const RefinedGrasp& grasp : refine_grasps(scene, parents, {}, options)) {
    const Trial& parent = parents[static_cast<std::size_t>(grasp.parent)].trial;
    EXPECT_EQ(grasp.gain, robust(grasp.trial) - robust(parent));
    EXPECT_GT(grasp.gain, 0.0);
  }
}

// As many trials as refine_trials says, at most those that the options allow, for any numbers.
TEST(RefineGrasps, KeepsToItsTrials) {
  for (const int grasps : {1, 2, 3, 4, 7}) {
    for (const int trials : {0, 1, 5, 16, 61, 160, 1000}) {
      RefineOptions options = few_trials(trials);
      options.grasps = grasps;
      const int most = refine_trials(10, options);
      EXPECT_LE(most, trials);
      // What is left over does not suffice for another variable of each grasp of a round.
      EXPECT_GE(most, trials - 2 * (2 * grasps + 3) - 3) << grasps << " " << trials;
    }
  }
  EXPECT_EQ(refine_trials(0), 0);
  const std::vector<TriedGrasp> parents = best_of_mug(4);
  for (const int trials : {0, 7, 50}) {
    std::vector<Progress> seen;
    RunContext context = {.threads = 2};
    context.progress = [&](const Progress& progress) { seen.push_back(progress); };
    int used = 0;
    RefineOptions options = few_trials(trials);
    options.grasps = 3;
    for (const RefinedGrasp& grasp :
         refine_grasps(mug_to_refine(), parents, {}, options, context)) {
      EXPECT_LT(grasp.parent, 3);
      used += grasp.trials_used;
    }
    const int total = refine_trials(parents.size(), options);
    EXPECT_LE(used, total);
    ASSERT_EQ(seen.size(), static_cast<std::size_t>(total) + 1);
    for (std::size_t i = 0; i < seen.size(); ++i) {
      EXPECT_EQ(seen[i].stage, Stage::refine);
      EXPECT_EQ(seen[i].done, static_cast<int>(i));
      EXPECT_EQ(seen[i].total, total);
    }
  }
}

TEST(RefineGrasps, NothingGivenNothingRefined) {
  EXPECT_TRUE(refine_grasps(mug_to_refine(), {}).empty());
  EXPECT_TRUE(refine_grasps(mug_to_refine(), best_of_mug(1), {}, few_trials(0)).empty());
}

TEST(RefineGrasps, RefusesGraspsThatDoNotHoldAndOptionsOutOfRange) {
  std::vector<TriedGrasp> grasps = best_of_mug(2);
  grasps[1].trial.outcome = Outcome::not_force_closure;
  const auto refusal = [&](const RefineOptions& options) {
    try {
      (void)refine_grasps(mug_to_refine(), grasps, {}, options);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(refusal({}), "grasps[1].trial: not stable (not_force_closure)");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusal({.grasps = 0}), "grasps: must be at least 1 (0)");
  EXPECT_EQ(refusal({.trials = -1}), "trials: must be at least 0 (-1)");
  EXPECT_EQ(refusal({.turn = 0.0}), "turn: must be above 0 (0)");
  EXPECT_EQ(refusal({.shift = nan}), "shift: must be above 0 (nan)");
  EXPECT_EQ(refusal({.noise = {.samples = 0}}), "noise.samples: must be at least 1 (0)");
}

TEST(RefineGrasps, CanBeCancelled) {
  const std::vector<TriedGrasp> parents = best_of_mug(2);
  RunContext before;
  before.cancellation.request();
  EXPECT_THROW(refine_grasps(mug_to_refine(), parents, {}, {}, before), Cancelled);
  for (const int threads : {1, 2}) {
    RunContext context = RunContext{.threads = threads};
    context.progress = [flag = context.cancellation](const Progress& progress) {
      if (progress.done == 5) flag.request();
    };
    EXPECT_THROW(refine_grasps(mug_to_refine(), parents, {}, {}, context), Cancelled);
  }
}

// The jaw comes down onto a box, `aside` [m] of its middle along the plates.
Candidate jaw_from_above(double aside) {
  Matrix3 down;
  down << 1, 0, 0, 0, -1, 0, 0, 0, -1;
  Candidate candidate;
  candidate.X_OH = pose_from(down, Vector3(0.0, aside, 0.05));
  candidate.approach_O = -Vector3::UnitZ();
  candidate.approach_distance = 0.05;
  candidate.preshape = 0;
  return candidate;
}

// Wrenches are taken about the middle of the box: there a jaw that comes straight down resists the
// most torque. Plates that lie across the corners of the box reach farther and resist more.
TEST(RefineGrasps, AJawThatHoldsABoxOffItsMiddleGoesToTheMiddle) {
  const CompiledScene scene =
      test::compiled(find_robot("parallel_jaw"), make_box({0.04, 0.12, 0.04}));
  const Candidate off = jaw_from_above(0.035);
  const Trial parent = run_trial(scene, off);
  ASSERT_EQ(parent.outcome, Outcome::stable);
  const Trial ideal = run_trial(scene, jaw_from_above(0.0));
  RefineOptions straight;
  straight.turn = 1e-6;
  const auto shifted = refine_grasps(scene, {{off, parent}}, {}, straight);
  ASSERT_EQ(shifted.size(), 1U);
  EXPECT_LT(std::abs(shifted[0].trial.X_OH.translation().y()), 0.01);
  EXPECT_GT(shifted[0].trial.epsilon.lower, parent.epsilon.lower);
  EXPECT_GT(shifted[0].trial.epsilon.lower, 0.9 * ideal.epsilon.lower);
  const auto turned = refine_grasps(scene, {{off, parent}});
  ASSERT_EQ(turned.size(), 1U);
  EXPECT_GT(turned[0].trial.epsilon.lower, 1.1 * ideal.epsilon.lower);
}

TEST(GraspMoves, AtZeroTheHandIsWhereItWas) {
  for (const TriedGrasp& grasp : best_of_mug(4)) {
    const GraspMoves moves(mug_to_refine(), grasp.candidate, grasp.trial, {0.3, 0.03, 0.3});
    // The Barrett hand has one degree of freedom that does not close.
    ASSERT_EQ(moves.variables(), 7U);
    const Candidate same = moves.at(std::vector<double>(7, 0.0));
    EXPECT_EQ(same.preshape, grasp.candidate.preshape);
    EXPECT_LT((same.approach_O - grasp.candidate.approach_O).norm(), 1e-12);
    const Vector3 way = same.X_OH.translation() - grasp.trial.X_OH.translation();
    // On along the approach by the overrun, or not at all.
    EXPECT_LT((way - way.norm() * same.approach_O).norm(), 1e-12);
    const bool stopped = grasp.trial.travel < grasp.candidate.approach_distance;
    EXPECT_NEAR(way.norm(), stopped ? GraspMoves::kOverrun : 0.0, 1e-12);
    EXPECT_NEAR(same.approach_distance - way.norm(), grasp.trial.travel, 1e-12);
  }
}

// A turn leaves the middle of the contacts where it is in the hand; a shift moves it by its length.
TEST(GraspMoves, TurnsAboutTheMiddleOfTheContacts) {
  const TriedGrasp grasp = best_of_mug(1).front();
  Vector3 p_OC = Vector3::Zero();
  for (const GraspContact& contact : grasp.trial.contacts) p_OC += contact.point.position;
  p_OC /= static_cast<double>(grasp.trial.contacts.size());
  const Vector3 p_HC = grasp.trial.X_OH.inverse() * p_OC;
  const GraspMoves moves(mug_to_refine(), grasp.candidate, grasp.trial, {0.3, 0.03, 0.3});
  Random random(3);
  int other_spreads = 0;
  for (int i = 0; i < 50; ++i) {
    std::vector<double> x(7);
    for (double& value : x) value = random.uniform(-1.0, 1.0);
    const Candidate moved = moves.at(x);
    const double overrun = moved.approach_distance - grasp.trial.travel;
    const Pose X_OH = translation(-overrun * moved.approach_O) * moved.X_OH;
    EXPECT_NEAR((X_OH * p_HC - p_OC).norm(), 0.03 * Vector3(x[3], x[4], x[5]).norm(), 1e-12);
    const Eigen::AngleAxisd turn(grasp.trial.X_OH.linear().transpose() * X_OH.linear());
    EXPECT_NEAR(turn.angle(), 0.3 * Vector3(x[0], x[1], x[2]).norm(), 1e-9);
    // A spread beyond its limit ends there, which may be where the preshape has it.
    const Robot& hand = mug_to_refine().scene.hand;
    const std::vector<double>& dofs =
        moved.preshape ? hand.hand->preshapes[index(*moved.preshape)].dofs : moved.dofs;
    for (std::size_t d = 0; d < hand.dofs.size(); ++d) {
      EXPECT_TRUE(within_limits(hand.dofs[d], dofs[d]));
    }
    other_spreads += moved.preshape ? 0 : 1;
  }
  EXPECT_GT(other_spreads, 10);
}

TEST(GraspMoves, WithoutSpreadThePreshapeStays) {
  const TriedGrasp grasp = best_of_mug(1).front();
  const GraspMoves moves(mug_to_refine(), grasp.candidate, grasp.trial, {0.3, 0.03, 0.0});
  ASSERT_EQ(moves.variables(), 6U);
  EXPECT_EQ(moves.at({1, -1, 1, -1, 1, -1}).preshape, grasp.candidate.preshape);
}

}  // namespace
}  // namespace prehend
