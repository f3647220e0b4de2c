// What a survey finds of robots whose reach and collisions are known.
#include "sim/robot/hand/posture_survey.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "sim/base/input_error.h"
#include "sim/robot/files/robot_file.h"
#include "sim/shape/basic_shapes.h"

namespace prehend {
namespace {

constexpr double kUpper = 0.3;  // lengths of the links of the planar arm [m]
constexpr double kLower = 0.2;

// Two joints about z, each moving a thin link along x, and a base on its own below.
Robot planar_arm(double elbow_limit) {
  Robot arm;
  arm.name = "planar";
  arm.chains = {{"arm", 0, 2}};
  for (const char* name : {"shoulder", "elbow"}) {
    Joint joint;
    joint.name = name;
    joint.dof = static_cast<int>(arm.joints.size());
    joint.parent = joint.dof - 1;
    joint.lower = joint.dof == 0 ? -std::numbers::pi : -elbow_limit;
    joint.upper = -joint.lower;
    joint.X_JA = translation({joint.dof == 0 ? kUpper : kLower, 0.0, 0.0});
    DegreeOfFreedom dof;
    dof.name = name;
    dof.lower = joint.lower;
    dof.upper = joint.upper;
    arm.joints.push_back(joint);
    arm.dofs.push_back(dof);
  }
  const auto bar = [](double length) {
    return transformed(make_box({length, 0.01, 0.01}), translation({-0.5 * length, 0.0, 0.0}));
  };
  arm.links.push_back(
      {"base", "metal", -1, transformed(make_box({0.1, 0.1, 0.1}), translation({0.0, 0.0, -1.0}))});
  arm.links.push_back({"upper", "metal", 0, bar(kUpper)});
  arm.links.push_back({"lower", "metal", 1, bar(kLower)});
  return arm;
}

TEST(PostureSurvey, OfAPlanarArmFillsTheRing) {
  const PostureSurvey survey = survey_postures(planar_arm(std::numbers::pi), 4000);
  EXPECT_EQ(survey.colliding, 0);
  ASSERT_EQ(survey.tips.size(), 1U);
  const TipWorkspace& tip = survey.tips.front();
  EXPECT_EQ(tip.name, "lower");
  ASSERT_EQ(tip.points.size(), 4000U);
  double nearest = 1.0;
  double folded = 0.0;
  for (const Vector3& p : tip.points) {
    EXPECT_EQ(p.z(), 0.0);
    nearest = std::min(nearest, p.norm());
    if (p.norm() * p.norm() < kUpper * kUpper + kLower * kLower) folded += 1.0;
  }
  EXPECT_LE(tip.farthest, kUpper + kLower + 1e-12);
  EXPECT_GT(tip.farthest, kUpper + kLower - 1e-3);
  EXPECT_GE(nearest, kUpper - kLower - 1e-12);
  EXPECT_LT(nearest, kUpper - kLower + 1e-3);
  // The elbow is bent by more than a right angle in half of the postures.
  EXPECT_NEAR(folded / 4000.0, 0.5, 0.03);
  EXPECT_NEAR(tip.box.upper.x(), kUpper + kLower, 0.01);
  EXPECT_NEAR(tip.box.lower.y(), -kUpper - kLower, 0.01);
}

// The links are next to each other and are never checked; a wall that the lower link can reach is.
TEST(PostureSurvey, CountsPosturesThatCollide) {
  Robot arm = planar_arm(std::numbers::pi);
  // All around the base at the distance 0.25 m, which the upper link crosses as well: exempt.
  TriangleMesh ring;
  constexpr int kPosts = 60;
  for (int i = 0; i < kPosts; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kPosts;
    append(ring, transformed(make_box({0.03, 0.03, 0.03}),
                             translation({0.25 * std::cos(angle), 0.25 * std::sin(angle), 0.0})));
  }
  arm.links.front().mesh = ring;
  arm.exempt_pairs = {{0, 1}};
  const PostureSurvey survey = survey_postures(arm, 1000);
  ASSERT_EQ(survey.pairs.size(), 1U);
  EXPECT_EQ(survey.pairs.front().first, 0);
  EXPECT_EQ(survey.pairs.front().second, 2);
  EXPECT_EQ(survey.pairs.front().postures, survey.colliding);
  EXPECT_EQ(survey.tips.front().points.size(), 1000U - static_cast<std::size_t>(survey.colliding));
  // Stretched it is clear of the ring, folded back it is not.
  EXPECT_GT(survey.colliding, 300);
  EXPECT_LT(survey.colliding, 800);
}

TEST(PostureSurvey, TipsOfAHandAreThoseOfItsFingers) {
  const Robot hand = find_robot("barrett");
  const PostureSurvey survey = survey_postures(hand, 200);
  ASSERT_EQ(survey.tips.size(), 3U);
  for (const TipWorkspace& tip : survey.tips) {
    EXPECT_GT(tip.farthest, 0.05) << tip.name;
    EXPECT_LT(tip.farthest, 0.25) << tip.name;
  }
}

TEST(PostureSurvey, IsTheSameForTheSameSeed) {
  const Robot hand = find_robot("dlr");
  const PostureSurvey first = survey_postures(hand, 100, 7);
  const PostureSurvey again = survey_postures(hand, 100, 7);
  EXPECT_EQ(first.colliding, again.colliding);
  for (std::size_t t = 0; t < first.tips.size(); ++t) {
    EXPECT_EQ(first.tips[t].points, again.tips[t].points);
  }
  const PostureSurvey other = survey_postures(hand, 100, 8);
  EXPECT_NE(first.tips.front().points, other.tips.front().points);
}

TEST(PostureSurvey, WhatHasNoLimitsIsDrawnFromOneTurn) {
  Robot arm = planar_arm(1.0);
  arm.dofs.front().lower = -std::numeric_limits<double>::infinity();
  arm.dofs.front().upper = std::numeric_limits<double>::infinity();
  const TipWorkspace tip = survey_postures(arm, 500).tips.front();
  EXPECT_GT(tip.box.upper.x(), 0.45);
  EXPECT_LT(tip.box.lower.x(), -0.45);
}

TEST(PostureSurvey, RefusesNoPostures) {
  EXPECT_THROW(survey_postures(planar_arm(1.0), 0), InputError);
}

}  // namespace
}  // namespace prehend
