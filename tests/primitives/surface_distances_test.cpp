// How far the surface is from its primitives, for shapes of which that is known.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "primitives/decompose.h"
#include "sim/base/input_error.h"
#include "sim/shape/basic_shapes.h"
#include "sim/shape/object_generator.h"

namespace prehend {
namespace {

TEST(SurfaceDistances, OfABoxAreZero) {
  for (const double size : {1e-3, 0.1, 10.0}) {
    const Decomposition parts = decompose(make_box(size * Vector3(1.0, 2.0, 3.0)));
    ASSERT_EQ(parts.primitives.size(), 1U);
    ASSERT_EQ(parts.distances_of.size(), 1U);
    // The fit ends when its steps are of the order of 1e-6 of the size.
    EXPECT_LE(parts.distances.largest, 1e-5 * size);
    EXPECT_EQ(parts.distances_of[0].largest, parts.distances.largest);
    EXPECT_EQ(parts.distances_of[0].median, parts.distances.median);
    EXPECT_NEAR(parts.tolerance, 0.05 * std::sqrt(14.0) * size, 1e-12 * size);
  }
}

// The vertices of these meshes are on their spheres, so that a triangle is farthest from the sphere
// at the foot of the perpendicular from the centre.
TEST(SurfaceDistances, OfTwoSpheresAreThoseOfTheirFacets) {
  constexpr double kRadius = 0.03;
  const TriangleMesh ball = make_sphere(kRadius, 2);
  double deepest = 0.0;
  for (const Triangle& t : ball.triangles) {
    const auto corner = [&](int i) -> const Vector3& {
      return ball.vertices[static_cast<std::size_t>(t[static_cast<std::size_t>(i)])];
    };
    const Vector3 normal = (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized();
    deepest = std::max(deepest, kRadius - std::abs(normal.dot(corner(0))));
  }
  TriangleMesh mesh = ball;
  append(mesh, transformed(ball, translation({0.2, 0.0, 0.0})));
  const Decomposition parts = decompose(mesh);
  ASSERT_EQ(parts.primitives.size(), 2U);
  ASSERT_EQ(parts.distances_of.size(), 2U);
  for (const SurfaceDistances& distances : parts.distances_of) {
    // Sampled points seldom hit the deepest ones.
    EXPECT_LE(distances.largest, 1.01 * deepest);
    EXPECT_GE(distances.largest, 0.8 * deepest);
    EXPECT_GT(distances.median, 0.2 * deepest);
    EXPECT_LE(distances.median, distances.percentile_95);
    EXPECT_LE(distances.percentile_95, distances.largest);
    EXPECT_LE(distances.largest, parts.distances.largest);
  }
}

TEST(SurfaceDistances, ShrinkWithTheTolerance) {
  for (const char* name : {"mug", "bottle"}) {
    const TriangleMesh mesh = generate_object(name);
    const Decomposition coarse = decompose(mesh);
    const double wanted = 0.2 * coarse.tolerance;
    const Decomposition fine = decompose(mesh, {.tolerance = relative_tolerance(mesh, wanted)});
    EXPECT_NEAR(fine.tolerance, wanted, 1e-12) << name;
    EXPECT_GE(fine.primitives.size(), coarse.primitives.size()) << name;
    EXPECT_LT(fine.distances.percentile_95, coarse.distances.percentile_95) << name;
  }
}

TEST(SurfaceDistances, AskedForByALength) {
  const TriangleMesh mesh = make_box({3.0, 4.0, 12.0});
  EXPECT_DOUBLE_EQ(relative_tolerance(mesh, 0.13), 0.01);
  EXPECT_DOUBLE_EQ(relative_tolerance(mesh, 13.0), 1.0);
  for (const double refused : {0.0, -1.0, 13.1, std::nan("")}) {
    EXPECT_THROW(relative_tolerance(mesh, refused), InputError) << refused;
  }
}

}  // namespace
}  // namespace prehend
