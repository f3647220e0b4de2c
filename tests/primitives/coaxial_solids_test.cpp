#include "primitives/coaxial_solids.h"

#include <gtest/gtest.h>

#include "primitives/decompose.h"
#include "sim/shape/make_mesh.h"
#include "sim/shape/revolve.h"
#include "tests/primitives/test_meshes.h"

namespace prehend {
namespace {

// A bottle about z: a body, a shoulder and a neck.
TriangleMesh bottle() {
  const std::vector<ProfileCorner> corners = {{{0.0, 0.0}},    {{0.04, 0.0}},  {{0.04, 0.12}},
                                              {{0.015, 0.16}}, {{0.015, 0.2}}, {{0.0, 0.2}}};
  return revolve(profile_points(corners, 0.004), 0.004).mesh;
}

const Primitive& nearest_to(const std::vector<Primitive>& all, const Vector3& p_O) {
  const Primitive* best = &all.front();
  for (const Primitive& primitive : all) {
    const auto apart = [&](const Primitive& one) { return (one.X_OP.translation() - p_O).norm(); };
    if (apart(primitive) < apart(*best)) best = &primitive;
  }
  return *best;
}

// Each solid of the bottle where it is, about one axis.
void expect_bottle(const std::vector<Primitive>& found, const Pose& X_NO, double within) {
  ASSERT_EQ(found.size(), 3U);
  for (const Primitive& solid : found) {
    EXPECT_GT(std::abs(solid.X_OP.linear().col(2).dot(X_NO.linear().col(2))),
              std::cos(10.0 * within));
    const Vector3 at = X_NO.inverse() * solid.X_OP.translation();
    EXPECT_LT(at.head<2>().norm(), within);
  }
  const Shape body = nearest_to(found, X_NO * Vector3(0.0, 0.0, 0.06)).shape;
  ASSERT_EQ(shape_name(body), "cylinder");
  EXPECT_NEAR(std::get<Cylinder>(body).radius, 0.04, within);
  EXPECT_NEAR(std::get<Cylinder>(body).height, 0.12, 3.0 * within);
  const Shape shoulder = nearest_to(found, X_NO * Vector3(0.0, 0.0, 0.14)).shape;
  ASSERT_EQ(shape_name(shoulder), "cone");
  const Cone& cone = std::get<Cone>(shoulder);
  EXPECT_NEAR(std::max(cone.radius_low, cone.radius_high), 0.04, 3.0 * within);
  EXPECT_NEAR(std::min(cone.radius_low, cone.radius_high), 0.015, 3.0 * within);
  const Shape neck = nearest_to(found, X_NO * Vector3(0.0, 0.0, 0.18)).shape;
  ASSERT_EQ(shape_name(neck), "cylinder");
  EXPECT_NEAR(std::get<Cylinder>(neck).radius, 0.015, within);
}

TEST(CoaxialSolids, ABottleIsThreeSolidsAboutOneAxisWhateverItsPose) {
  Random random(8);
  for (int i = 0; i < 5; ++i) {
    SCOPED_TRACE(i);
    const Pose X_NO = random.pose(0.5);
    expect_bottle(decompose(transformed(bottle(), X_NO)).primitives, X_NO, 1e-3);
  }
}

TEST(CoaxialSolids, NoiseDoesNotChangeThem) {
  Random random(9);
  for (int i = 0; i < 3; ++i) {
    SCOPED_TRACE(i);
    expect_bottle(decompose(test::disturbed(bottle(), 1e-3, random)).primitives, Pose::Identity(),
                  2e-3);
  }
}

// Of what is seen from one side, and of half a profile, the axis and the radii are still there.
TEST(CoaxialSolids, HalfABottleIsABottle) {
  const TriangleMesh whole = bottle();
  TriangleMesh half{whole.vertices, {}};
  for (const Triangle& t : whole.triangles) {
    double middle = 0.0;
    for (const int v : t) middle += whole.vertices[static_cast<std::size_t>(v)].x() / 3.0;
    if (middle > -0.005) half.triangles.push_back(t);
  }
  expect_bottle(decompose(half).primitives, Pose::Identity(), 2e-3);
}

TEST(CoaxialSolids, WhatIsNotRoundIsLeft) {
  const Decomposition box = decompose(make_box({0.2, 0.12, 0.06}, 10));
  ASSERT_EQ(box.primitives.size(), 1U);
  EXPECT_EQ(shape_name(box.primitives.front().shape), "box");
}

}  // namespace
}  // namespace prehend
