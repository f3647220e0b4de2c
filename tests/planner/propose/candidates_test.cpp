// Candidates against the rules that they come from.
#include "planner/propose/candidates.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "planner/propose/grasp_rules.h"
#include "sim/geometry/object_generator.h"
#include "sim/trial/approach.h"
#include "tests/support/scenes.h"

namespace prehend {
namespace {

constexpr double kRounding = 1e-12;

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
  if (grasp.rule != aim.rule) return false;
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
    CandidateOptions options;
    options.max_candidates = 100000;
    const Proposals proposals = propose_grasps(scene, pieces, options);
    ASSERT_FALSE(proposals.grasps.empty()) << name;
    for (const ProposedGrasp& grasp : proposals.grasps) {
      const Matrix3 rotation = grasp.candidate.X_OH.linear();
      EXPECT_LT((rotation.transpose() * rotation - Matrix3::Identity()).norm(), kRounding);
      EXPECT_GT(rotation.determinant(), 0.0);
      EXPECT_LT((rotation * hand.approach - grasp.candidate.approach_O).norm(), kRounding);
      const auto aims = aim_at(pieces[static_cast<std::size_t>(grasp.primitive)], options.rules);
      const Preshape& preshape = preshape_of(scene, grasp);
      const auto explains = [&](const AimedGrasp& aim) {
        return aim.width >= preshape.min_width && aim.width <= preshape.max_width &&
               follows(scene, grasp, aim);
      };
      ASSERT_TRUE(std::any_of(aims.begin(), aims.end(), explains)) << name << " " << grasp.rule;
    }
  }
}

TEST(Candidates, CloseOnWhatTheirPreshapeTakesAndSayWhenNothingFits) {
  const CompiledScene scene = mug_scene("franka_hand");  // opens to 80 mm
  const std::vector<Primitive> wide = {{Sphere{0.05}, Pose::Identity()},
                                       {Box{{0.09, 0.1, 0.11}}, Pose::Identity()}};
  const Proposals none = propose_grasps(scene, wide);
  EXPECT_TRUE(none.grasps.empty());
  EXPECT_DOUBLE_EQ(none.smallest_width, 0.09);
  EXPECT_DOUBLE_EQ(none.largest_opening, 0.08);
  const std::vector<Primitive> one_side = {{Box{{0.09, 0.08, 0.11}}, Pose::Identity()}};
  const Proposals some = propose_grasps(scene, one_side);
  EXPECT_FALSE(some.grasps.empty());
  for (const ProposedGrasp& grasp : some.grasps) {
    const Vector3 closing = grasp.candidate.X_OH.linear() * scene.scene.hand.hand->closing;
    EXPECT_NEAR(std::abs(closing.y()), 1.0, kRounding);
  }
}

TEST(Candidates, NoTwoAreTheSame) {
  const CompiledScene scene = mug_scene("barrett");
  std::vector<Primitive> pieces = primitives();
  const std::size_t once = propose_grasps(scene, pieces, {.max_candidates = 100000}).grasps.size();
  // The same pieces again, moved by far less than the tolerance, add nothing.
  for (std::size_t i = 0; i < 3; ++i) {
    pieces.push_back(pieces[i]);
    pieces.back().X_OP = translation({0.0, 0.0, 1e-4}) * pieces.back().X_OP;
  }
  const CandidateOptions options{.max_candidates = 100000};
  const Proposals proposals = propose_grasps(scene, pieces, options);
  EXPECT_EQ(proposals.grasps.size(), once);
  for (std::size_t i = 0; i < proposals.grasps.size(); ++i) {
    const Candidate& a = proposals.grasps[i].candidate;
    for (std::size_t k = 0; k < i; ++k) {
      const Candidate& b = proposals.grasps[k].candidate;
      if (a.preshape != b.preshape) continue;
      const double apart = (a.X_OH.translation() - b.X_OH.translation()).norm();
      // Angle of the turn between them, from its trace.
      const double cosine = 0.5 * ((a.X_OH.linear().transpose() * b.X_OH.linear()).trace() - 1.0);
      ASSERT_TRUE(apart > options.duplicate_distance ||
                  cosine < std::cos(options.duplicate_angle) + kRounding)
          << i << " and " << k;
    }
  }
}

TEST(Candidates, AreNeverMoreThanAskedFor) {
  const CompiledScene scene = mug_scene("barrett");
  const auto count = [&](int most) {
    return propose_grasps(scene, primitives(), {.max_candidates = most}).grasps.size();
  };
  const std::size_t all = count(100000);
  ASSERT_GT(all, 100U);
  EXPECT_EQ(count(1), 1U);
  EXPECT_EQ(count(97), 97U);
  EXPECT_EQ(count(static_cast<int>(all)), all);
  // Evenly over the list, so that every primitive stays.
  std::vector<int> of_primitive(3, 0);
  for (const auto& grasp : propose_grasps(scene, primitives(), {.max_candidates = 97}).grasps) {
    ++of_primitive[static_cast<std::size_t>(grasp.primitive)];
  }
  for (const int n : of_primitive) EXPECT_GT(n, 0);
}

TEST(Candidates, StartFreeOfTheObject) {
  const CompiledScene scene = mug_scene("barrett");
  for (const ProposedGrasp& grasp : propose_grasps(scene, primitives()).grasps) {
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
