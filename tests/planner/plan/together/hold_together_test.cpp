// Pairs of grasps of two hands, and the motions of the arms that carry them.
#include "planner/plan/together/hold_together.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "planner/plan/plan.h"
#include "planner/plan/together/posed_links.h"
#include "sim/scene/compiled_scene.h"
#include "sim/scene/scene_file.h"
#include "sim/shape/basic_shapes.h"
#include "tests/support/refusal_of.h"
#include "tests/support/scenes.h"

namespace prehend {
namespace {

// The two scenes of the library with a crate between two arms, and their plans.
struct Crate {
  CompiledScene left = compile(load_scene("crate_left"));
  CompiledScene right = compile(load_scene("crate_right"));
  PlanResult left_plan = plan(left, options());
  PlanResult right_plan = plan(right, options());

  static PlanOptions options() {
    PlanOptions options;
    options.search.trials = 120;
    options.refine.trials = 0;
    options.free_closing = 0;
    options.volumes = false;
    options.rank.top = 100;
    return options;
  }

  std::array<HandPlan, 2> plans() const { return {{{left, left_plan}, {right, right_plan}}}; }
};

const Crate& crate() {
  static const Crate shared;
  return shared;
}

TogetherOptions few() {
  TogetherOptions options;
  options.top = 1;
  options.pool = 8;
  options.lifts = 4;
  return options;
}

// Neither hand bears the crate or keeps it when it rises alone; both together do.
TEST(HoldTogether, LiftsWhatNeitherHandHolds) {
  const TogetherResult result = hold_together(crate().plans(), few());
  ASSERT_EQ(result.grasps.size(), 1U);
  const SharedGrasp& pair = result.grasps.front();
  EXPECT_EQ(pair.lift.end, SharedLiftEnd::lifted);
  EXPECT_NEAR(pair.lift.risen, 0.1, 0.01);
  EXPECT_LT(pair.lift.tilt, 0.1);
  EXPECT_GE(pair.strength, 1.0);
  EXPECT_GT(pair.epsilon.lower, 0.0);
  for (std::size_t side = 0; side < 2; ++side) {
    const HandPlan plan = crate().plans()[side];
    const Trial& trial = plan.result.grasps[pair.grasps[side]].trial;
    EXPECT_LT(pair.alone[side], 1.0);
    EXPECT_DOUBLE_EQ(pair.alone[side], weight_strength(plan.scene, trial));
    EXPECT_GT(pair.epsilon.lower, trial.epsilon.lower);
    const HoldingHand hand{plan.scene, trial};
    EXPECT_NE(lift_together(std::span(&hand, 1)).end, SharedLiftEnd::lifted);
  }
}

TEST(HoldTogether, IsTheSameOnAnyNumberOfThreads) {
  const TogetherResult one = hold_together(crate().plans(), few(), {.threads = 1});
  const TogetherResult two = hold_together(crate().plans(), few(), {.threads = 2});
  ASSERT_EQ(one.grasps.size(), two.grasps.size());
  EXPECT_EQ(one.bear, two.bear);
  for (std::size_t i = 0; i < one.grasps.size(); ++i) {
    EXPECT_EQ(one.grasps[i].grasps, two.grasps[i].grasps);
    EXPECT_EQ(one.grasps[i].epsilon.lower, two.grasps[i].epsilon.lower);
    EXPECT_EQ(one.grasps[i].lift.risen, two.grasps[i].lift.risen);
  }
}

// Of links where the arms are: which of them are nearer than allowed is asked pair by pair.
void expect_apart(const std::vector<double>& left, const std::vector<double>& right) {
  EXPECT_TRUE(are_apart(links_at(crate().left, left), links_at(crate().right, right), 1e-5));
}

Pose hand_in_world(const CompiledScene& scene, const std::vector<double>& joints) {
  const PlatformPart& part = scene.arm->hand_part();
  return scene.arm->X_WB * joint_pose(scene.arm->robot(), part.joint, joints) * part.X_JR;
}

TEST(HoldTogether, MovesTheArmsOneAfterTheOtherAndLiftsWithBoth) {
  TogetherOptions options = few();
  options.paths.emplace();
  const TogetherResult result = hold_together(crate().plans(), options);
  ASSERT_EQ(result.grasps.size(), 1U);
  ASSERT_TRUE(result.grasps[0].paths.has_value());
  const std::array<Trajectory, 2>& reach = result.grasps[0].paths->reach;
  const std::array<Trajectory, 2>& lift = result.grasps[0].paths->lift;
  const CompiledScene& left = crate().left;
  const CompiledScene& right = crate().right;
  const std::vector<double> right_start = joint_values(right.arm->robot(), right.arm->start);
  for (const auto& joints : reach[0].positions) expect_apart(joints, right_start);
  for (const auto& joints : reach[1].positions) expect_apart(reach[0].positions.back(), joints);
  // Both hands hold the crate as they rise: neither moves or turns against the other.
  ASSERT_EQ(lift[0].times, lift[1].times);
  const auto relative = [&](std::size_t k) {
    return hand_in_world(left, lift[0].positions[k]).inverse() *
           hand_in_world(right, lift[1].positions[k]);
  };
  const double start = hand_in_world(left, lift[0].positions[0]).translation().z();
  double height = 0.0;
  for (std::size_t k = 0; k < lift[0].times.size(); ++k) {
    expect_apart(lift[0].positions[k], lift[1].positions[k]);
    EXPECT_TRUE(relative(k).isApprox(relative(0), 1e-3));
    EXPECT_LT((relative(k).translation() - relative(0).translation()).norm(), 1e-4);
    const double now = hand_in_world(left, lift[0].positions[k]).translation().z() - start;
    EXPECT_GE(now, height - 1e-6);
    height = now;
  }
  EXPECT_NEAR(height, options.lift.height, 1e-6);
}

// An arm in whose start the other one stands has no way. Here both are the same arm.
TEST(HoldTogether, HasNoPathsWhereOneArmStandsInTheOther) {
  const SharedHold hold{crate().left, crate().left_plan.grasps.front()};
  EXPECT_FALSE(plan_shared_paths({{hold, hold}}, {}).has_value());
}

TEST(HoldTogether, RefusesDifferentObjects) {
  Scene other = crate().right.scene;
  other.object.mass += 0.1;
  const CompiledScene heavier = compile(std::move(other));
  const std::array<HandPlan, 2> plans = {
      {{crate().left, crate().left_plan}, {heavier, crate().right_plan}}};
  const InputError refusal = test::refusal_of([&] { hold_together(plans); });
  EXPECT_NE(std::string(refusal.what()).find("must be the same in both scenes"), std::string::npos);
}

// A cube beside another, nearer and farther than asked, and one inside another.
TEST(PosedLinks, AreApartByMoreThanAsked) {
  const CollisionBody small = make_collision_body("small", make_box(Vector3::Constant(0.1)), true);
  const CollisionBody large = make_collision_body("large", make_box(Vector3::Constant(0.5)), true);
  const auto at = [](const CollisionBody& body, double x) {
    return std::vector<PosedLink>{{&body, translation(Vector3(x, 0.02, 0.01))}};
  };
  EXPECT_TRUE(are_apart(at(small, 0.0), at(small, 0.111), 0.01));
  EXPECT_FALSE(are_apart(at(small, 0.0), at(small, 0.109), 0.01));
  EXPECT_FALSE(are_apart(at(small, 0.0), at(large, 0.0), 0.01));
  EXPECT_FALSE(are_apart(at(large, 0.0), at(small, 0.05), 0.0));
}

}  // namespace
}  // namespace prehend
