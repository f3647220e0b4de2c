// Candidates against the rules that they come from.
#include "planner/plan/propose/candidates.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "planner/plan/propose/grasp_rules.h"
#include "planner/plan/propose/proposal_sequence.h"
#include "sim/base/index.h"
#include "sim/shape/object_generator.h"
#include "sim/trial/approach.h"
#include "tests/support/scenes.h"

namespace prehend {
namespace {

constexpr double kRounding = 1e-12;
constexpr std::size_t kMany = 2000;

CompiledScene mug_scene(const char* hand) {
  return test::compiled(find_robot(hand), generate_object("mug", 2000));
}

// The cup, its handle as a box, and a ball around all of it, so that every rule is used.
std::vector<Primitive> primitives() {
  return {{Cylinder{0.052, 0.105}, translation({0.0, 0.0, 0.0525})},
          {Box{{0.03, 0.014, 0.07}}, translation({0.068, 0.0, 0.0525})},
          {Sphere{0.04}, translation({0.0, 0.0, 0.05})}};
}

const Preshape& preshape_of(const CompiledScene& scene, const ProposedGrasp& grasp) {
  return scene.scene.hand.hand->preshapes[index(*grasp.candidate.preshape)];
}

// True when the hand at the end of its approach points along the aim, with its origin on the line
// of approach through the target, in it or short of it by the preshape's depth.
bool follows(const CompiledScene& scene, const ProposedGrasp& grasp, const AimedGrasp& aim) {
  const Hand& hand = *scene.scene.hand.hand;
  const Candidate& candidate = grasp.candidate;
  if ((candidate.approach_O - aim.approach_O).norm() > kRounding) return false;
  const Matrix3 rotation = candidate.X_OH.linear();
  if ((rotation * hand.closing - aim.closing_O).norm() > kRounding) return false;
  const Vector3 short_of = aim.target_O - candidate.X_OH * hand.origin;
  const double along = short_of.dot(aim.approach_O);
  if ((short_of - along * aim.approach_O).norm() > kRounding) return false;
  return std::abs(along) < kRounding ||
         std::abs(along - preshape_of(scene, grasp).depth) < kRounding;
}

TEST(Candidates, AreAimedByARuleOfTheirPrimitive) {
  const std::vector<Primitive> pieces = primitives();
  for (const char* name : {"barrett", "parallel_jaw_wide", "franka_hand"}) {
    const CompiledScene scene = mug_scene(name);
    const Hand& hand = *scene.scene.hand.hand;
    const Proposals proposals = propose_grasps(scene, pieces, kMany);
    ASSERT_EQ(proposals.grasps.size(), kMany) << name;
    for (const ProposedGrasp& grasp : proposals.grasps) {
      const Matrix3 rotation = grasp.candidate.X_OH.linear();
      EXPECT_LT((rotation.transpose() * rotation - Matrix3::Identity()).norm(), kRounding);
      EXPECT_GT(rotation.determinant(), 0.0);
      EXPECT_LT((rotation * hand.approach - grasp.candidate.approach_O).norm(), kRounding);
      const Preshape& preshape = preshape_of(scene, grasp);
      const auto explains = [&](const GraspRule& rule) {
        return rule.name == grasp.rule && rule.freedoms.size() == grasp.choices.size() &&
               rule.width >= preshape.min_width && rule.width <= preshape.max_width &&
               follows(scene, grasp, rule.aim(grasp.choices));
      };
      const auto rules = grasp_rules(pieces[index(grasp.primitive)]);
      ASSERT_TRUE(std::any_of(rules.begin(), rules.end(), explains)) << name << " " << grasp.rule;
    }
  }
}

TEST(Candidates, CloseOnWhatTheirPreshapeTakesAndSayWhenNothingFits) {
  const CompiledScene scene = mug_scene("franka_hand");  // opens to 80 mm
  const std::vector<Primitive> wide = {{Sphere{0.05}, Pose::Identity()},
                                       {Box{{0.09, 0.1, 0.11}}, Pose::Identity()}};
  const Proposals none = propose_grasps(scene, wide, kMany);
  EXPECT_TRUE(none.grasps.empty());
  EXPECT_DOUBLE_EQ(none.smallest_width, 0.09);
  EXPECT_DOUBLE_EQ(none.largest_opening, 0.08);
  const std::vector<Primitive> one_side = {{Box{{0.09, 0.08, 0.11}}, Pose::Identity()}};
  const Proposals some = propose_grasps(scene, one_side, kMany);
  EXPECT_FALSE(some.grasps.empty());
  for (const ProposedGrasp& grasp : some.grasps) {
    const Vector3 closing = grasp.candidate.X_OH.linear() * scene.scene.hand.hand->closing;
    EXPECT_NEAR(std::abs(closing.y()), 1.0, kRounding);
  }
}

// True when the hand's poses are farther apart than a duplicate, at the level of the later one.
bool differ(const ProposedGrasp& a, const ProposedGrasp& b) {
  if (a.candidate.preshape != b.candidate.preshape) return true;
  const double part = std::pow(0.5, std::max(a.level, b.level));
  const Pose& X_OA = a.candidate.X_OH;
  const Pose& X_OB = b.candidate.X_OH;
  const double apart = (X_OA.translation() - X_OB.translation()).norm();
  // Angle of the turn between them, from its trace.
  const double cosine = 0.5 * ((X_OA.linear().transpose() * X_OB.linear()).trace() - 1.0);
  return apart > part * kDuplicateDistance || cosine < std::cos(part * kDuplicateAngle) + kRounding;
}

TEST(Candidates, NoTwoAreTheSame) {
  const CompiledScene scene = mug_scene("barrett");
  // The same pieces twice, moved by less than a duplicate may be.
  std::vector<Primitive> pieces = primitives();
  for (std::size_t i = 0; i < 3; ++i) {
    pieces.push_back(pieces[i]);
    pieces.back().X_OP = translation({0.0, 0.0, 1e-4}) * pieces.back().X_OP;
  }
  const Proposals proposals = propose_grasps(scene, pieces, kMany);
  for (std::size_t i = 0; i < proposals.grasps.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      ASSERT_TRUE(differ(proposals.grasps[i], proposals.grasps[k])) << i << " and " << k;
    }
  }
}

TEST(Candidates, AreAsManyAsAskedForAndFewerAreTheFirst) {
  const CompiledScene scene = mug_scene("barrett");
  const auto many = propose_grasps(scene, primitives(), kMany).grasps;
  for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{97}}) {
    const auto few = propose_grasps(scene, primitives(), count).grasps;
    ASSERT_EQ(few.size(), count);
    for (std::size_t i = 0; i < count; ++i) {
      EXPECT_TRUE(few[i].candidate.X_OH.matrix() == many[i].candidate.X_OH.matrix());
      EXPECT_EQ(few[i].way, many[i].way);
    }
  }
}

TEST(Candidates, BeginCoarseAndWithEveryPrimitive) {
  const CompiledScene scene = mug_scene("barrett");
  const auto grasps = propose_grasps(scene, primitives(), kMany).grasps;
  for (std::size_t i = 1; i < grasps.size(); ++i) EXPECT_GE(grasps[i].level, grasps[i - 1].level);
  std::vector<int> of_primitive(3, 0);
  for (std::size_t i = 0; i < 48; ++i) ++of_primitive[index(grasps[i].primitive)];
  for (const int n : of_primitive) EXPECT_GT(n, 0);
}

TEST(ProposalSequence, WhatLiesBesideAGraspIsNearItAndNotProposedAgain) {
  const CompiledScene scene = mug_scene("barrett");
  const CandidateOptions options;
  ProposalSequence sequence(scene, primitives(), options);
  std::vector<ProposedGrasp> all;
  for (int i = 0; i < 50; ++i) all.push_back(sequence.next(Track::solids).value());
  const ProposedGrasp middle = all[20];
  const auto beside = sequence.beside(middle);
  ASSERT_FALSE(beside.empty());
  for (const ProposedGrasp& grasp : beside) {
    EXPECT_EQ(grasp.primitive, middle.primitive);
    EXPECT_EQ(grasp.rule, middle.rule);
    // Either one freedom by half a step or another preshape or depth.
    int moved = grasp.way != middle.way ? 1 : 0;
    for (std::size_t k = 0; k < middle.choices.size(); ++k) {
      if (grasp.choices[k] != middle.choices[k]) ++moved;
    }
    EXPECT_EQ(moved, 1);
    all.push_back(grasp);
  }
  EXPECT_TRUE(sequence.beside(middle).empty());
  for (std::size_t i = 0; i < kMany; ++i) all.push_back(sequence.next(Track::solids).value());
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      ASSERT_TRUE(differ(all[i], all[k])) << i << " and " << k;
    }
  }
}

TEST(ProposalSequence, WithoutAPrimitiveIsEmpty) {
  const CompiledScene scene = mug_scene("parallel_jaw_wide");
  ProposalSequence none(scene, {}, {});
  EXPECT_FALSE(none.next(Track::solids).has_value());
  EXPECT_FALSE(none.next(Track::curves).has_value());
  EXPECT_EQ(none.families(), 0);
}

TEST(Candidates, StartFreeOfTheObject) {
  const CompiledScene scene = mug_scene("barrett");
  for (const ProposedGrasp& grasp : propose_grasps(scene, primitives(), 400).grasps) {
    const Candidate& candidate = grasp.candidate;
    const ApproachMotion motion{candidate.X_OH, candidate.approach_O, candidate.approach_distance};
    const auto poses = test::link_poses_in_object(
        scene, motion.at(0.0), joint_values(scene.scene.hand, preshape_of(scene, grasp).dofs));
    for (std::size_t l = 0; l < poses.size(); ++l) {
      ASSERT_FALSE(surfaces_cross(scene.object().mesh, scene.links[l].mesh, poses[l]))
          << grasp.rule;
      ASSERT_FALSE(is_inside(scene.object().mesh, poses[l] * scene.links[l].probes.front()));
    }
  }
}

}  // namespace
}  // namespace prehend
