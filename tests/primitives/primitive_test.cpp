#include "sim/shape/primitive.h"

#include <numbers>

#include <gtest/gtest.h>

#include "primitives/near_surface.h"
#include "primitives/primitive_surface.h"
#include "sim/base/random.h"
#include "tests/primitives/test_meshes.h"

namespace prehend {
namespace {

using std::numbers::pi;

constexpr double kRounding = 1e-12;

std::vector<Shape> some_shapes() {
  return {Box{{1.0, 2.0, 3.0}}, Box{{0.1, 5.0, 0.2}}, Sphere{0.5},         Sphere{3.0},
          Cylinder{0.5, 2.0},   Cylinder{2.0, 0.1},   Cone{1.0, 0.3, 2.0}, Cone{0.0, 1.0, 0.5}};
}

TEST(Primitive, NamesAreTheShapes) {
  EXPECT_EQ(shape_name(Box{}), "box");
  EXPECT_EQ(shape_name(Sphere{}), "sphere");
  EXPECT_EQ(shape_name(Cylinder{}), "cylinder");
  EXPECT_EQ(shape_name(Cone{}), "cone");
  EXPECT_EQ(shape_name(Rim{}), "rim");
  EXPECT_EQ(shape_name(Bar{}), "bar");
}

TEST(Primitive, AreaIsTheClosedForm) {
  EXPECT_NEAR(surface_area(Shape(Box{{1.0, 2.0, 3.0}})), 22.0, kRounding);
  EXPECT_NEAR(surface_area(Shape(Sphere{2.0})), 16.0 * pi, kRounding);
  EXPECT_NEAR(surface_area(Shape(Cylinder{2.0, 3.0})), 2.0 * pi * 2.0 * 5.0, kRounding);
}

TEST(Primitive, DistanceFromABox) {
  const Primitive box{Box{{2.0, 4.0, 6.0}}, Pose::Identity()};
  EXPECT_NEAR(signed_distance(box, {0.0, 0.0, 0.0}), -1.0, kRounding);
  EXPECT_NEAR(signed_distance(box, {0.0, 1.5, 0.0}), -0.5, kRounding);
  EXPECT_NEAR(signed_distance(box, {1.0, 0.0, 0.0}), 0.0, kRounding);
  EXPECT_NEAR(signed_distance(box, {0.0, 0.0, -5.0}), 2.0, kRounding);
  EXPECT_NEAR(signed_distance(box, {4.0, 6.0, 0.0}), 5.0, kRounding);
  EXPECT_NEAR(signed_distance(box, {3.0, 5.0, 4.0}), std::sqrt(4.0 + 9.0 + 1.0), kRounding);
}

TEST(Primitive, DistanceFromASphere) {
  const Primitive sphere{Sphere{2.0}, Pose::Identity()};
  EXPECT_NEAR(signed_distance(sphere, {0.0, 0.0, 0.0}), -2.0, kRounding);
  EXPECT_NEAR(signed_distance(sphere, {0.0, 3.0, 4.0}), 3.0, kRounding);
}

TEST(Primitive, DistanceFromACylinder) {
  const Primitive cylinder{Cylinder{1.0, 4.0}, Pose::Identity()};
  EXPECT_NEAR(signed_distance(cylinder, {0.0, 0.0, 0.0}), -1.0, kRounding);
  EXPECT_NEAR(signed_distance(cylinder, {0.0, 0.0, 1.75}), -0.25, kRounding);
  EXPECT_NEAR(signed_distance(cylinder, {0.0, 3.0, 1.0}), 2.0, kRounding);
  EXPECT_NEAR(signed_distance(cylinder, {0.0, 0.5, 5.0}), 3.0, kRounding);
  EXPECT_NEAR(signed_distance(cylinder, {4.0, 0.0, -6.0}), 5.0, kRounding);
}

// Radius 3 at the bottom, none at the top, 4 high: the side is 5 long.
TEST(Primitive, AreaOfAConeAndDistanceFromIt) {
  const Primitive cone{Cone{3.0, 0.0, 4.0}, Pose::Identity()};
  EXPECT_NEAR(surface_area(cone.shape), pi * 9.0 + pi * 3.0 * 5.0, kRounding);
  EXPECT_NEAR(signed_distance(cone, {0.0, 0.0, 7.0}), 5.0, kRounding);
  EXPECT_NEAR(signed_distance(cone, {0.0, 0.0, -3.0}), 1.0, kRounding);
  EXPECT_NEAR(signed_distance(cone, {1.5 + 4.0, 0.0, 0.0 + 3.0}), 5.0, kRounding);
  EXPECT_NEAR(signed_distance(cone, {0.0, 0.0, -1.5}), -0.5, kRounding);
  EXPECT_NEAR(signed_distance(cone, {1.5, 0.0, 0.0}), 0.0, kRounding);
}

TEST(Primitive, AConeWithEqualRadiiIsACylinder) {
  Random random(63);
  const Primitive cone{Cone{0.7, 0.7, 2.0}, Pose::Identity()};
  const Primitive cylinder{Cylinder{0.7, 2.0}, Pose::Identity()};
  EXPECT_NEAR(surface_area(cone.shape), surface_area(cylinder.shape), kRounding);
  for (int i = 0; i < 200; ++i) {
    const Vector3 p = random.vector(0.0, 2.0);
    EXPECT_NEAR(signed_distance(cone, p), signed_distance(cylinder, p), kRounding);
  }
}

TEST(Primitive, ACurveIsATubeAroundIt) {
  const Bar bar{{{0.0, 0.0, 0.0}, {3.0, 0.0, 0.0}, {3.0, 4.0, 0.0}}, 0.5, false};
  EXPECT_NEAR(curve_length(bar.points, false), 7.0, kRounding);
  EXPECT_NEAR(curve_length(bar.points, true), 12.0, kRounding);
  EXPECT_NEAR(surface_area(bar), pi * 0.5 * 7.0, kRounding);
  EXPECT_NEAR(signed_distance({bar, Pose::Identity()}, {1.0, 0.0, 2.0}), 1.75, kRounding);
  EXPECT_NEAR(signed_distance({bar, Pose::Identity()}, {1.5, 2.0, 0.0}), 1.25, kRounding);
  Bar loop = bar;
  loop.closed = true;
  EXPECT_NEAR(signed_distance({loop, Pose::Identity()}, {1.5, 2.0, 0.0}), -0.25, kRounding);
}

TEST(Primitive, DistanceMovesWithTheFrame) {
  Random random(1);
  for (const Shape& shape : some_shapes()) {
    for (int i = 0; i < 20; ++i) {
      const Pose X_OP = random.pose(2.0);
      const Vector3 p_P = random.vector(0.0, 4.0);
      EXPECT_NEAR(signed_distance({shape, X_OP}, X_OP * p_P),
                  signed_distance({shape, Pose::Identity()}, p_P), 1e-9);
    }
  }
}

TEST(SpreadPoints, LieOnTheSurfaceAndAddUpToItsArea) {
  Random random(2);
  for (const Shape& shape : some_shapes()) {
    const Primitive primitive{shape, random.pose(2.0)};
    double area = 0.0;
    for (const PatchPoint& patch : spread_points(primitive, 200)) {
      EXPECT_NEAR(signed_distance(primitive, patch.p_O), 0.0, 1e-9) << shape_name(shape);
      area += patch.area;
    }
    EXPECT_NEAR(area, surface_area(shape), 1e-9 * area) << shape_name(shape);
  }
}

TEST(NearSurface, KnowsTheDistanceToItsPointsToACell) {
  Random random(3);
  std::vector<SurfacePoint> points(5);
  for (SurfacePoint& s : points) s.p_O = random.vector(0.0, 1.0);
  constexpr double kRadius = 0.2;
  const NearSurface near(points, kRadius);
  for (int i = 0; i < 2000; ++i) {
    const Vector3 p = random.vector(0.0, 2.0);
    double distance = 1e9;
    for (const SurfacePoint& s : points) distance = std::min(distance, (s.p_O - p).norm());
    // Half the diagonal of a cell, which is a third of the radius wide, decides in between.
    constexpr double kCell = 0.5 * 1.7321 / 3.0 * kRadius;
    if (distance < kRadius - kCell) {
      EXPECT_TRUE(near.near(p)) << distance;
    }
    if (distance > kRadius + kCell) {
      EXPECT_FALSE(near.near(p)) << distance;
    }
  }
}

}  // namespace
}  // namespace prehend
