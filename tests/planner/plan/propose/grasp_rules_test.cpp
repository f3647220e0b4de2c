// What each primitive proposes, before a hand is known.
#include "planner/plan/propose/grasp_rules.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

#include "sim/base/random.h"

namespace prehend {
namespace {

constexpr double kRuleRounding = 1e-12;

// What a rule gives for one value of each of its freedoms.
struct Aim {
  std::string rule;
  double width = 0.0;
  AimedGrasp grasp;
};

// Calls `use` with each combination of the values that the freedoms have at this level.
template <typename Use>
void for_all_choices(const std::vector<Freedom>& freedoms, int level, std::vector<double>& choices,
                     const Use& use) {
  if (choices.size() == freedoms.size()) return use(choices);
  const Freedom freedom = freedoms[choices.size()];
  for (int i = 0; i < choice_count(freedom, level); ++i) {
    choices.push_back(choice_at(freedom, level, i));
    for_all_choices(freedoms, level, choices, use);
    choices.pop_back();
  }
}

// All aims of all rules of a primitive at a level of detail.
std::vector<Aim> aims_at(const Primitive& primitive, int level) {
  std::vector<Aim> aims;
  for (const GraspRule& rule : grasp_rules(primitive)) {
    std::vector<double> none;
    for_all_choices(rule.freedoms, level, none, [&](const std::vector<double>& choices) {
      aims.push_back({rule.name, rule.width, rule.aim(choices)});
    });
  }
  return aims;
}

std::map<std::string, int> count_by_rule(const std::vector<Aim>& aims) {
  std::map<std::string, int> counts;
  for (const Aim& aim : aims) ++counts[aim.rule];
  return counts;
}

void expect_orthonormal(const std::vector<Aim>& aims) {
  for (const auto& [rule, width, grasp] : aims) {
    EXPECT_NEAR(grasp.approach_O.norm(), 1.0, kRuleRounding);
    EXPECT_NEAR(grasp.closing_O.norm(), 1.0, kRuleRounding);
    EXPECT_NEAR(grasp.approach_O.dot(grasp.closing_O), 0.0, kRuleRounding);
  }
}

// Each aim has a partner that differs in the side of the thumb alone.
void expect_thumb_on_either_side(const std::vector<Aim>& aims) {
  for (const Aim& a : aims) {
    const auto is_other_side = [&](const Aim& b) {
      return (a.grasp.target_O - b.grasp.target_O).norm() < kRuleRounding &&
             (a.grasp.approach_O - b.grasp.approach_O).norm() < kRuleRounding &&
             (a.grasp.closing_O + b.grasp.closing_O).norm() < kRuleRounding && a.width == b.width;
    };
    EXPECT_TRUE(std::any_of(aims.begin(), aims.end(), is_other_side)) << a.rule;
  }
}

TEST(GraspRules, ABoxIsHeldByOppositeFacesFromTheFourOtherSides) {
  Random random(141);
  const Vector3 size(0.02, 0.06, 0.1);
  const Primitive primitive{Box{size}, random.pose(0.2)};
  const auto aims = aims_at(primitive, 1);  // at three places
  EXPECT_EQ(aims.size(), 3U * 4U * 3U * 2U);
  expect_orthonormal(aims);
  expect_thumb_on_either_side(aims);
  const Pose X_PO = primitive.X_OP.inverse();
  for (const auto& [rule, width, grasp] : aims) {
    const Vector3 closing = X_PO.linear() * grasp.closing_O;
    const Vector3 approach = X_PO.linear() * grasp.approach_O;
    const Vector3 target = X_PO * grasp.target_O;
    // Along an axis of the box, as wide as the box is there.
    EXPECT_NEAR(closing.cwiseAbs().maxCoeff(), 1.0, kRuleRounding);
    EXPECT_NEAR(approach.cwiseAbs().maxCoeff(), 1.0, kRuleRounding);
    EXPECT_NEAR(closing.cwiseAbs().dot(size), width, kRuleRounding);
    // On the line through the middle along the remaining axis, inside the box.
    EXPECT_NEAR(target.dot(closing), 0.0, kRuleRounding);
    EXPECT_NEAR(target.dot(approach), 0.0, kRuleRounding);
    EXPECT_LT((target.cwiseAbs() - 0.5 * size).maxCoeff(), 0.0);
  }
}

TEST(GraspRules, ACylinderIsHeldFromItsSideAndItsEnds) {
  Random random(142);
  const Primitive primitive{Cylinder{0.03, 0.12}, random.pose(0.2)};
  const auto aims = aims_at(primitive, 1);  // eight directions, three places
  expect_orthonormal(aims);
  expect_thumb_on_either_side(aims);
  const auto counts = count_by_rule(aims);
  EXPECT_EQ(counts.at("cylinder side, thumb across"), 8 * 3 * 2);
  EXPECT_EQ(counts.at("cylinder side, thumb along"), 8 * 2);
  EXPECT_EQ(counts.at("cylinder end"), 8 * 2);
  const Pose X_PO = primitive.X_OP.inverse();
  for (const auto& [rule, width, grasp] : aims) {
    const Vector3 target = X_PO * grasp.target_O;
    const Vector3 approach = X_PO.linear() * grasp.approach_O;
    EXPECT_NEAR(target.head<2>().norm(), 0.0, kRuleRounding) << "off the axis";
    if (rule == "cylinder end") {
      EXPECT_NEAR(target.z(), -0.06 * approach.z(), kRuleRounding) << "comes from inside";
    } else {
      EXPECT_NEAR(approach.z(), 0.0, kRuleRounding);
      EXPECT_LT(std::abs(target.z()), 0.06);
    }
    EXPECT_EQ(width, rule == "cylinder side, thumb along" ? 0.12 : 0.06);
  }
}

TEST(GraspRules, ASphereIsHeldFromAllDirections) {
  const Primitive primitive{Sphere{0.04}, translation({0.1, 0.2, 0.3})};
  const auto aims = aims_at(primitive, 1);  // five heights, eight directions, eight turns
  EXPECT_EQ(aims.size(), 5U * 8U * 8U);
  expect_orthonormal(aims);
  expect_thumb_on_either_side(aims);
  Random random(143);
  for (int i = 0; i < 200; ++i) {
    const Vector3 direction = random.direction();
    double nearest = -1.0;
    for (const Aim& aim : aims) nearest = std::max(nearest, direction.dot(aim.grasp.approach_O));
    // The heights are 0, 1/2 and 1 of the radius: at most 60 degrees from ring to ring and 45 from
    // direction to direction.
    EXPECT_GT(nearest, std::cos(0.6));
  }
  for (const Aim& aim : aims) {
    EXPECT_LT((aim.grasp.target_O - Vector3(0.1, 0.2, 0.3)).norm(), kRuleRounding);
    EXPECT_EQ(aim.width, 0.08);
  }
}

TEST(GraspRules, TheChoicesOfALevelAreAmongThoseOfTheNextAndEvenlySpaced) {
  for (const Freedom freedom : {Freedom::place, Freedom::span, Freedom::turn}) {
    std::set<double> before;
    for (int level = 0; level <= 5; ++level) {
      std::set<double> choices;
      for (int i = 0; i < choice_count(freedom, level); ++i) {
        const double choice = choice_at(freedom, level, i);
        EXPECT_EQ(is_new_choice(freedom, level, i), !before.contains(choice));
        choices.insert(choice);
      }
      EXPECT_EQ(choices.size(), static_cast<std::size_t>(choice_count(freedom, level)));
      EXPECT_TRUE(std::includes(choices.begin(), choices.end(), before.begin(), before.end()));
      EXPECT_EQ(*choices.begin() == 0.0, freedom != Freedom::place);
      EXPECT_EQ(*choices.rbegin() == 1.0, freedom == Freedom::span);
      const double step = 1.0 / (freedom == Freedom::turn ? 4 << level : 2 << level);
      double last = *choices.begin();
      for (const double choice : choices) {
        EXPECT_TRUE(choice == last || choice == last + step) << level;
        last = choice;
      }
      before = choices;
    }
  }
}

TEST(GraspRules, AConeIsHeldFromItsSideAndItsEnds) {
  Random random(144);
  const Primitive primitive{Cone{0.03, 0.01, 0.12}, random.pose(0.2)};
  const auto aims = aims_at(primitive, 1);
  expect_orthonormal(aims);
  expect_thumb_on_either_side(aims);
  const Pose X_PO = primitive.X_OP.inverse();
  for (const auto& [rule, width, grasp] : aims) {
    const Vector3 target = X_PO * grasp.target_O;
    EXPECT_NEAR(target.head<2>().norm(), 0.0, kRuleRounding) << "off the axis";
    if (rule == "cone side, thumb across") {
      EXPECT_NEAR(width, target.z() < 0.0 ? 0.06 : 0.04, kRuleRounding);
    } else if (rule == "cone end") {
      EXPECT_NEAR(width, target.z() < 0.0 ? 0.06 : 0.02, kRuleRounding);
    }
  }
}

TEST(GraspRules, ARimIsHeldFromItsEdgeWithTheWallBetweenTheFingers) {
  Random random(145);
  Rim rim{{}, 0.003, 0.02, true};
  constexpr int kPoints = 64;
  for (int i = 0; i < kPoints; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kPoints;
    const Vector3 out(std::cos(angle), std::sin(angle), 0.0);
    rim.points.push_back({0.05 * out, -Vector3::UnitZ(), out});
  }
  const Primitive primitive{rim, random.pose(0.2)};
  const auto aims = aims_at(primitive, 1);
  EXPECT_EQ(aims.size(), 8U * 3U * 2U);
  expect_orthonormal(aims);
  expect_thumb_on_either_side(aims);
  const Pose X_PO = primitive.X_OP.inverse();
  for (const auto& [rule, width, grasp] : aims) {
    EXPECT_EQ(width, 0.003);
    const Vector3 target = X_PO * grasp.target_O;
    EXPECT_NEAR(target.head<2>().norm(), 0.05, 1e-4);
    EXPECT_LT(target.z(), 0.0);
    EXPECT_GT(target.z(), -rim.depth);
    EXPECT_NEAR((X_PO.linear() * grasp.approach_O).z(), -1.0, kRuleRounding);
    const Vector3 closing = X_PO.linear() * grasp.closing_O;
    EXPECT_NEAR(std::abs(closing.dot(target)), 0.05, 1e-4);
  }
}

TEST(GraspRules, ABarIsHeldAcrossIt) {
  Random random(146);
  Bar bar{{}, 0.01, false};
  constexpr int kPoints = 33;
  for (int i = 0; i < kPoints; ++i) {
    const double angle = std::numbers::pi * i / (kPoints - 1);
    bar.points.emplace_back(0.04 * std::cos(angle), 0.0, 0.04 * std::sin(angle));
  }
  const Primitive primitive{bar, random.pose(0.2)};
  const auto aims = aims_at(primitive, 1);
  EXPECT_EQ(aims.size(), 8U * 3U * 2U);
  expect_orthonormal(aims);
  expect_thumb_on_either_side(aims);
  const Pose X_PO = primitive.X_OP.inverse();
  for (const auto& [rule, width, grasp] : aims) {
    const Vector3 target = X_PO * grasp.target_O;
    EXPECT_NEAR(target.norm(), 0.04, 1e-4);
    const Vector3 along = Vector3::UnitY().cross(target).normalized();
    EXPECT_NEAR((X_PO.linear() * grasp.approach_O).dot(along), 0.0, 2e-3);
    EXPECT_NEAR((X_PO.linear() * grasp.closing_O).dot(along), 0.0, 2e-3);
  }
}

// Where a curve comes back on itself there is no direction between those of two points that follow
// each other.
TEST(GraspRules, FoldedCurvesHaveDirectionsToo) {
  const Pose here = Pose::Identity();
  const Vector3 z = Vector3::UnitZ();
  const Vector3 x = Vector3::UnitX();
  // The tangents of the second and the third point are opposite; those of the first bar's two
  // points have no length but for the step between them.
  const std::vector<Primitive> folded = {
      {Bar{{{0, 0, 0}, {0.02, 0, 0}}, 0.01, true}, here},
      {Bar{{{0, 0, 0}, {0.02, 0, 0}, {0.001, 0, 0}}, 0.01, false}, here},
      {Rim{{{{0, 0, 0}, z, x}, {{0.02, 0, 0}, -z, x}}, 0.003, 0.02, false}, here},
      {Rim{{{{0, 0, 0}, z, x}, {{0.02, 0, 0}, -z, -x}}, 0.003, 0.02, true}, here}};
  for (const Primitive& primitive : folded) {
    const auto aims = aims_at(primitive, 3);
    EXPECT_FALSE(aims.empty());
    expect_orthonormal(aims);
  }
}

// The points of the curve that the surface of a thin handle led to, most of them copies but for
// rounding.
TEST(GraspRules, ABarWithRepeatedPointsIsHeldAsWithoutThem) {
  Random random(147);
  const std::vector<Vector3> corners = {
      {0, 0, 0}, {0.02, 0, 0.01}, {0.03, 0, 0.03}, {0.03, 0, 0.05}};
  Bar copied{{}, 0.01, false};
  for (const Vector3& p : corners) {
    for (int copy = 0; copy < 5; ++copy) copied.points.push_back(p + random.in_box(1e-12));
  }
  const auto aims = aims_at({copied, Pose::Identity()}, 2);
  const auto expected = aims_at({Bar{corners, 0.01, false}, Pose::Identity()}, 2);
  expect_orthonormal(aims);
  ASSERT_EQ(aims.size(), expected.size());
  for (std::size_t i = 0; i < aims.size(); ++i) {
    EXPECT_LT((aims[i].grasp.target_O - expected[i].grasp.target_O).norm(), 1e-9);
    EXPECT_LT((aims[i].grasp.approach_O - expected[i].grasp.approach_O).norm(), 1e-9);
  }
  const Bar point{{corners[0], corners[0], corners[0]}, 0.01, false};
  EXPECT_TRUE(grasp_rules({point, Pose::Identity()}).empty());
}

}  // namespace
}  // namespace prehend
