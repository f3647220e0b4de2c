#include "sim/shape/convex_parts.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "sim/base/random.h"
#include "sim/shape/convex_hull.h"
#include "sim/shape/object_generator.h"

namespace prehend {
namespace {

// How far a set reaches along a unit direction.
double support(const ConvexPoints& set, const Vector3& direction) {
  double most = -1e9;
  for (const Vector3& p : set.points()) most = std::max(most, p.dot(direction));
  return most + set.margin();
}

// Points on an ellipsoid with these half axes [m].
std::vector<Vector3> ellipsoid(const Vector3& half, int count) {
  Random random(3);
  std::vector<Vector3> points;
  for (int i = 0; i < count; ++i) points.push_back(half.cwiseProduct(random.direction()));
  return points;
}

// The definition of a set that contains the other: it reaches at least as far in all directions.
TEST(CoarseHull, ContainsTheHullAndIsCloseToIt) {
  for (const Vector3& half : {Vector3(0.04, 0.04, 0.04), Vector3(0.01, 0.02, 0.1)}) {
    const ConvexPoints fine{ellipsoid(half, 4000)};
    const ConvexPoints coarse = coarse_hull(convex_hull(fine.points()), 256);
    EXPECT_LE(coarse.points().size(), 256U);
    EXPECT_LT(coarse.margin(), 0.02 * half.maxCoeff());
    Random random(4);
    for (int i = 0; i < 2000; ++i) {
      const Vector3 direction = random.direction();
      ASSERT_GE(support(coarse, direction), support(fine, direction) - 1e-15);
    }
  }
}

TEST(CoarseHull, OfFewCornersHasNoMargin) {
  const std::vector<Vector3> cube{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0},
                                  {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
  const ConvexPoints coarse = coarse_hull(convex_hull(cube), 256);
  EXPECT_EQ(coarse.points().size(), cube.size());
  EXPECT_EQ(coarse.margin(), 0.0);
}

TEST(ConvexParts, OfARoundMeshOfManyTrianglesAreFewPoints) {
  const TriangleMesh mesh = convex_hull(ellipsoid({0.03, 0.03, 0.05}, 4000));
  const std::vector<ConvexPoints> parts = convex_parts(mesh);
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_LE(parts.front().points().size(), 256U);
  EXPECT_GT(parts.front().margin(), 0.0);
}

// A lower bound must not exceed the distance of any two points.
TEST(ConvexParts, SeparationStaysBelowTheDistanceOfTheSurfaces) {
  const TriangleMesh mesh = convex_hull(ellipsoid({0.03, 0.03, 0.05}, 4000));
  const ConvexPoints round = convex_parts(mesh).front();
  const ConvexPoints ball{ellipsoid({0.02, 0.02, 0.02}, 100)};
  for (double apart = 0.0505; apart < 0.08; apart += 0.001) {
    const Pose X_AB = translation({apart, 0.0, 0.0});
    double least = 1e9;
    for (const Vector3& p : mesh.vertices) {
      for (const Vector3& q : ball.points()) least = std::min(least, (X_AB * q - p).norm());
    }
    Vector3 direction = Vector3::Zero();
    EXPECT_LE(separation(round, ball, X_AB, direction), least);
  }
}

}  // namespace
}  // namespace prehend
