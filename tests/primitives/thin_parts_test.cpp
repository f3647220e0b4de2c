// Rims and bars of meshes of known shape.
#include "primitives/thin_parts.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "primitives/spot_curves.h"
#include "sim/base/random.h"
#include "sim/shape/basic_shapes.h"
#include "sim/shape/proximity_mesh.h"
#include "sim/shape/revolve.h"
#include "tests/primitives/test_meshes.h"

namespace prehend {
namespace {

using std::numbers::pi;

constexpr double kCupRadius = 0.04;
constexpr double kCupHeight = 0.08;
constexpr double kWall = 0.003;

// Open at the top, with a flat lip.
TriangleMesh cup() {
  std::vector<ProfileCorner> profile{
      {{0.0, 0.0}, 0.0}, {{kCupRadius, 0.0}, 0.0}, {{kCupRadius, kCupHeight}, 0.0}};
  for (const ProfileCorner& corner : inner_side(profile, kWall)) profile.push_back(corner);
  return revolve(profile_points(profile, 0.004), 0.004).mesh;
}

// A circle of radius `tube` about each point of a circle of radius `ring` in the plane z = 0.
TriangleMesh torus(double ring, double tube) {
  constexpr int kAround = 60;
  constexpr int kAcross = 24;
  TriangleMesh mesh;
  const auto vertex = [](int i, int j) { return (i % kAround) * kAcross + j % kAcross; };
  for (int i = 0; i < kAround; ++i) {
    for (int j = 0; j < kAcross; ++j) {
      const double u = 2.0 * pi * i / kAround;
      const double v = 2.0 * pi * j / kAcross;
      const double rho = ring + tube * std::cos(v);
      mesh.vertices.emplace_back(rho * std::cos(u), rho * std::sin(u), tube * std::sin(v));
      mesh.triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      mesh.triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  }
  return mesh;
}

std::vector<Primitive> thin_parts_of(const TriangleMesh& mesh, int threads = 1) {
  return find_thin_parts(ProximityMesh(mesh), {}, {}, {.threads = threads});
}

TEST(SpotCurves, HaveNoPointTwiceWhereSpotsAreFarApart) {
  std::vector<ThinSpot> spots;
  for (const double x : {0.0, 0.001, 0.002, 0.003, 0.004, 0.03, 0.06, 0.09}) {
    spots.push_back({{x, 0.0, 0.0}, -Vector3::UnitZ(), Vector3::UnitY(), 0.003, 0.02});
  }
  const std::vector<SpotCurve> curves = spot_curves(spots, 0.04, 0.01);
  ASSERT_EQ(curves.size(), 1U);
  const std::vector<ThinSpot>& places = curves[0].places;
  ASSERT_GE(places.size(), 4U);
  for (std::size_t i = 1; i < places.size(); ++i) {
    EXPECT_GT((places[i].p - places[i - 1].p).norm(), 1e-8) << i;
  }
}

TEST(ThinParts, OfACupAreItsLip) {
  const auto parts = thin_parts_of(cup());
  ASSERT_EQ(parts.size(), 1U);
  const Rim& rim = std::get<Rim>(parts[0].shape);
  EXPECT_TRUE(rim.closed);
  EXPECT_NEAR(rim.width, kWall, 0.03 * kWall);
  EXPECT_GT(rim.depth, 0.01);
  const double middle = kCupRadius - 0.5 * kWall;
  EXPECT_NEAR(curve_length(points_of(rim), true), 2.0 * pi * middle, 0.05 * 2.0 * pi * middle);
  for (const RimPoint& at : rim.points) {
    EXPECT_NEAR(at.p.z(), kCupHeight, 1e-6);
    EXPECT_NEAR(at.p.head<2>().norm(), middle, 0.3 * kWall) << "beside the wall";
    EXPECT_LT(at.into.z(), -0.999);
    EXPECT_NEAR(at.into.dot(at.across), 0.0, 1e-9);
    EXPECT_GT(std::abs(at.across.dot(Vector3(at.p.x(), at.p.y(), 0.0).normalized())), 0.98);
  }
}

// The wall of a shallow bowl leaves the straight line long before its edge.
TEST(ThinParts, TheEdgeOfABentWallIsFound) {
  constexpr double kRadius = 0.08;
  constexpr double kThin = 0.0015;
  std::vector<Eigen::Vector2d> profile;
  constexpr int kSteps = 30;
  for (int i = 0; i <= kSteps; ++i) {
    const double polar = 0.5 * pi * i / kSteps;
    profile.emplace_back(kRadius * std::sin(polar), -kRadius * std::cos(polar));
  }
  for (int i = kSteps; i >= 0; --i) {
    const double polar = 0.5 * pi * i / kSteps;
    const double inside = kRadius - kThin;
    profile.emplace_back(inside * std::sin(polar), -inside * std::cos(polar));
  }
  profile.front().x() = 0.0;
  profile.back().x() = 0.0;
  const auto parts = thin_parts_of(revolve(profile, 0.005).mesh);
  ASSERT_EQ(parts.size(), 1U);
  const Rim& rim = std::get<Rim>(parts[0].shape);
  EXPECT_TRUE(rim.closed);
  EXPECT_NEAR(rim.width, kThin, 0.05 * kThin);
  for (const RimPoint& at : rim.points) EXPECT_NEAR(at.p.z(), 0.0, 1e-4);
}

TEST(ThinParts, OfARingAreABarAllTheWayAround) {
  const auto parts = thin_parts_of(torus(0.04, 0.004));
  ASSERT_EQ(parts.size(), 1U);
  const Bar& bar = std::get<Bar>(parts[0].shape);
  EXPECT_TRUE(bar.closed);
  EXPECT_NEAR(bar.width, 0.008, 0.05 * 0.008);
  for (const Vector3& p : bar.points) {
    EXPECT_NEAR(p.z(), 0.0, 0.001);
    EXPECT_NEAR(p.head<2>().norm(), 0.04, 0.0015);
  }
}

TEST(ThinParts, SolidsHaveNone) {
  EXPECT_TRUE(thin_parts_of(make_box({0.1, 0.06, 0.05}, 4)).empty());
  EXPECT_TRUE(thin_parts_of(make_sphere(0.03)).empty());
  EXPECT_TRUE(thin_parts_of(make_cylinder(0.03, 0.1)).empty());
}

TEST(ThinParts, WhatASolidDescribesIsLeftOut) {
  const ProximityMesh plate(make_box({0.2, 0.15, 0.006}, 8));
  EXPECT_FALSE(find_thin_parts(plate, {}).empty());
  const Primitive box{Box{{0.2, 0.15, 0.006}}, Pose::Identity()};
  EXPECT_TRUE(find_thin_parts(plate, {box}).empty());
  const ProximityMesh stick(make_cylinder(0.004, 0.15, 24, 20));
  EXPECT_FALSE(find_thin_parts(stick, {}).empty());
  const Primitive cylinder{Cylinder{0.004, 0.15}, Pose::Identity()};
  EXPECT_TRUE(find_thin_parts(stick, {cylinder}).empty());
}

TEST(ThinParts, MoveWithTheMesh) {
  Random random(71);
  const TriangleMesh mesh = cup();
  const Rim rim = std::get<Rim>(thin_parts_of(mesh)[0].shape);
  for (int i = 0; i < 5; ++i) {
    const Pose X = random.pose(0.5);
    const auto moved = thin_parts_of(transformed(mesh, X));
    ASSERT_EQ(moved.size(), 1U);
    const Rim& there = std::get<Rim>(moved[0].shape);
    EXPECT_NEAR(there.width, rim.width, 1e-2 * rim.width);
    const Pose back = X.inverse();
    for (const RimPoint& at : there.points) {
      const Primitive here{rim, Pose::Identity()};
      EXPECT_LT(signed_distance(here, back * at.p), 0.0);
      EXPECT_LT((back.linear() * at.into).z(), -0.99);
    }
  }
}

TEST(ThinParts, ScaleWithTheMesh) {
  const TriangleMesh mesh = cup();
  const Rim rim = std::get<Rim>(thin_parts_of(mesh)[0].shape);
  for (const double factor : {0.03, 0.1, 1000.0 * 0.03}) {
    const auto parts = thin_parts_of(test::scaled(mesh, factor));
    ASSERT_EQ(parts.size(), 1U);
    const Rim& scaled = std::get<Rim>(parts[0].shape);
    EXPECT_NEAR(scaled.width, factor * rim.width, 1e-3 * factor * rim.width);
    EXPECT_NEAR(curve_length(points_of(scaled), true), factor * curve_length(points_of(rim), true),
                1e-2 * factor * 0.25);
  }
}

TEST(ThinParts, AreTheSameOnAnyNumberOfThreads) {
  const Rim one = std::get<Rim>(thin_parts_of(cup(), 1)[0].shape);
  const Rim four = std::get<Rim>(thin_parts_of(cup(), 4)[0].shape);
  ASSERT_EQ(one.points.size(), four.points.size());
  EXPECT_EQ(one.width, four.width);
  for (std::size_t i = 0; i < one.points.size(); ++i) {
    EXPECT_EQ(one.points[i].p, four.points[i].p);
    EXPECT_EQ(one.points[i].into, four.points[i].into);
    EXPECT_EQ(one.points[i].across, four.points[i].across);
  }
}

// What bounds no wall is no rim; none of these may end the program.
TEST(ThinParts, OfSurfacesThatAreNotClosed) {
  const TriangleMesh open = test::without_triangles_above(make_sphere(0.05), 0.0);
  EXPECT_TRUE(thin_parts_of(open).empty());
  TriangleMesh sheet{{{0.0, 0.0, 0.0}, {0.1, 0.0, 0.0}, {0.0, 0.1, 0.0}}, {{0, 1, 2}}};
  EXPECT_TRUE(thin_parts_of(sheet).empty());
  sheet.triangles.push_back({0, 2, 1});
  EXPECT_TRUE(thin_parts_of(sheet).empty()) << "both sides in one place";
  Random random(72);
  const TriangleMesh soup = test::triangle_soup(200, random);
  for (const Primitive& part : thin_parts_of(soup)) {
    EXPECT_TRUE(std::isfinite(surface_area(part.shape)));
  }
  TriangleMesh without_area{{{0.0, 0.0, 0.0}, {0.1, 0.0, 0.0}}, {{0, 1, 1}}};
  EXPECT_TRUE(thin_parts_of(without_area).empty());
}

TEST(ThinParts, AreLeftOutWhereNotAskedFor) {
  const ProximityMesh mesh(cup());
  EXPECT_TRUE(find_thin_parts(mesh, {}, {.rim_width = 0.0, .bar_width = 0.0}).empty());
  EXPECT_TRUE(find_thin_parts(mesh, {}, {.most_rims = 0}).empty());
}

}  // namespace
}  // namespace prehend
