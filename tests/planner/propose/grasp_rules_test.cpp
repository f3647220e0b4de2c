// What each primitive proposes, before a hand is known.
#include "planner/propose/grasp_rules.h"

#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "sim/base/random.h"

namespace prehend {
namespace {

constexpr double kRuleRounding = 1e-12;

std::map<std::string, int> count_by_rule(const std::vector<AimedGrasp>& grasps) {
  std::map<std::string, int> counts;
  for (const AimedGrasp& grasp : grasps) ++counts[grasp.rule];
  return counts;
}

void expect_orthonormal(const std::vector<AimedGrasp>& grasps) {
  for (const AimedGrasp& grasp : grasps) {
    EXPECT_NEAR(grasp.approach_O.norm(), 1.0, kRuleRounding);
    EXPECT_NEAR(grasp.closing_O.norm(), 1.0, kRuleRounding);
    EXPECT_NEAR(grasp.approach_O.dot(grasp.closing_O), 0.0, kRuleRounding);
  }
}

// Each aim has a partner that differs in the side of the thumb alone.
void expect_thumb_on_either_side(const std::vector<AimedGrasp>& grasps) {
  for (const AimedGrasp& a : grasps) {
    const auto is_other_side = [&](const AimedGrasp& b) {
      return (a.target_O - b.target_O).norm() < kRuleRounding &&
             (a.approach_O - b.approach_O).norm() < kRuleRounding &&
             (a.closing_O + b.closing_O).norm() < kRuleRounding && a.width == b.width;
    };
    EXPECT_TRUE(std::any_of(grasps.begin(), grasps.end(), is_other_side)) << a.rule;
  }
}

TEST(GraspRules, ABoxIsHeldByOppositeFacesFromTheFourOtherSides) {
  Random random(141);
  const Vector3 size(0.02, 0.06, 0.1);
  const Primitive primitive{Box{size}, random.pose(0.2)};
  GraspRuleOptions options;
  options.places = 3;
  const auto grasps = aim_at(primitive, options);
  EXPECT_EQ(grasps.size(), 3U * 4U * 3U * 2U);
  expect_orthonormal(grasps);
  expect_thumb_on_either_side(grasps);
  const Pose X_PO = primitive.X_OP.inverse();
  for (const AimedGrasp& grasp : grasps) {
    const Vector3 closing = X_PO.linear() * grasp.closing_O;
    const Vector3 approach = X_PO.linear() * grasp.approach_O;
    const Vector3 target = X_PO * grasp.target_O;
    // Along an axis of the box, as wide as the box is there.
    EXPECT_NEAR(closing.cwiseAbs().maxCoeff(), 1.0, kRuleRounding);
    EXPECT_NEAR(approach.cwiseAbs().maxCoeff(), 1.0, kRuleRounding);
    EXPECT_NEAR(closing.cwiseAbs().dot(size), grasp.width, kRuleRounding);
    // On the line through the middle along the remaining axis, inside the box.
    EXPECT_NEAR(target.dot(closing), 0.0, kRuleRounding);
    EXPECT_NEAR(target.dot(approach), 0.0, kRuleRounding);
    EXPECT_LT((target.cwiseAbs() - 0.5 * size).maxCoeff(), 0.0);
  }
}

TEST(GraspRules, ACylinderIsHeldFromItsSideAndItsEnds) {
  Random random(142);
  const Primitive primitive{Cylinder{0.03, 0.12}, random.pose(0.2)};
  GraspRuleOptions options;
  options.cylinder_directions = 8;
  options.places = 3;
  const auto grasps = aim_at(primitive, options);
  expect_orthonormal(grasps);
  expect_thumb_on_either_side(grasps);
  const auto counts = count_by_rule(grasps);
  EXPECT_EQ(counts.at("cylinder side, thumb across"), 8 * 3 * 2);
  EXPECT_EQ(counts.at("cylinder side, thumb along"), 8 * 2);
  EXPECT_EQ(counts.at("cylinder end"), 4 * 2 * 2);
  const Pose X_PO = primitive.X_OP.inverse();
  for (const AimedGrasp& grasp : grasps) {
    const Vector3 target = X_PO * grasp.target_O;
    const Vector3 approach = X_PO.linear() * grasp.approach_O;
    EXPECT_NEAR(target.head<2>().norm(), 0.0, kRuleRounding) << "off the axis";
    if (grasp.rule == "cylinder end") {
      EXPECT_NEAR(target.z(), -0.06 * approach.z(), kRuleRounding) << "comes from inside";
    } else {
      EXPECT_NEAR(approach.z(), 0.0, kRuleRounding);
      EXPECT_LT(std::abs(target.z()), 0.06);
    }
    EXPECT_EQ(grasp.width, grasp.rule == "cylinder side, thumb along" ? 0.12 : 0.06);
  }
}

TEST(GraspRules, ASphereIsHeldFromAllDirections) {
  const Primitive primitive{Sphere{0.04}, translation({0.1, 0.2, 0.3})};
  GraspRuleOptions options;
  options.sphere_directions = 50;
  options.sphere_turns = 3;
  const auto grasps = aim_at(primitive, options);
  EXPECT_EQ(grasps.size(), 50U * 3U * 2U);
  expect_orthonormal(grasps);
  expect_thumb_on_either_side(grasps);
  Random random(143);
  for (int i = 0; i < 200; ++i) {
    const Vector3 direction = random.direction();
    double nearest = -1.0;
    for (const AimedGrasp& grasp : grasps) {
      nearest = std::max(nearest, direction.dot(grasp.approach_O));
    }
    // 50 directions: caps of 4 pi / 50 have a half angle of 16 degrees, gaps less than twice that.
    EXPECT_GT(nearest, std::cos(0.55));
  }
  for (const AimedGrasp& grasp : grasps) {
    EXPECT_LT((grasp.target_O - Vector3(0.1, 0.2, 0.3)).norm(), kRuleRounding);
    EXPECT_EQ(grasp.width, 0.08);
  }
}

}  // namespace
}  // namespace prehend
