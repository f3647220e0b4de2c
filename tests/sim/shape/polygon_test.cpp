#include "sim/shape/polygon.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "sim/base/random.h"

namespace prehend {
namespace {

using Polygon = std::vector<Eigen::Vector2d>;

// The triangles must be counter-clockwise and add up to the polygon.
void expect_split(const Polygon& polygon) {
  const std::vector<Triangle> triangles = triangulate_polygon(polygon);
  ASSERT_EQ(triangles.size(), polygon.size() - 2);
  double sum = 0.0;
  for (const Triangle& t : triangles) {
    Polygon corners;
    for (const int v : t) corners.push_back(polygon[static_cast<std::size_t>(v)]);
    EXPECT_GT(doubled_area(corners), 0.0);
    sum += doubled_area(corners);
  }
  EXPECT_NEAR(sum, doubled_area(polygon), 1e-12 * doubled_area(polygon));
}

TEST(Polygon, SplitsConvexConcaveAndSpiralPolygons) {
  expect_split({{0, 0}, {1, 0}, {0, 1}});
  expect_split({{0, 0}, {2, 0}, {2, 2}, {1, 0.5}, {0, 2}});
  expect_split({{0, 0},
                {5, 0},
                {5, 5},
                {1, 5},
                {1, 2},
                {3, 2},
                {3, 3},
                {2, 3},
                {2, 4},
                {4, 4},
                {4, 1},
                {0, 1}});
}

TEST(Polygon, KeepsStraightCorners) {
  expect_split({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}});
  expect_split({{0, 0}, {1, 0}, {2, 0}, {1, 3}});
}

TEST(Polygon, SplitsRandomStars) {
  Random random(7);
  for (int round = 0; round < 200; ++round) {
    const int n = 3 + static_cast<int>(random.index(40));
    Polygon star;
    for (int k = 0; k < n; ++k) {
      const double radius = 0.1 + random.uniform();
      const double angle = 2.0 * std::numbers::pi * k / n;
      star.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    SCOPED_TRACE(round);
    expect_split(star);
  }
}

TEST(Polygon, HasNoSplitWhenClockwiseFlatOrCrossing) {
  EXPECT_TRUE(triangulate_polygon({{0, 0}, {0, 1}, {1, 0}}).empty());
  EXPECT_TRUE(triangulate_polygon({{0, 0}, {1, 0}, {2, 0}}).empty());
  EXPECT_TRUE(triangulate_polygon({{0, 0}, {1, 0}}).empty());
  EXPECT_TRUE(triangulate_polygon({}).empty());
}

TEST(Face, IsSplitInItsOwnPlaneAndKeepsItsWinding) {
  // A dart in the plane x = 1, seen from -x counter-clockwise.
  const std::vector<Vector3> dart{{1, 0, 0}, {1, 2, 2}, {1, 0.5, 0}, {1, 2, -2}};
  Vector3 sum = Vector3::Zero();
  for (const Triangle& t : triangulate_face(dart)) {
    const Vector3& a = dart[static_cast<std::size_t>(t[0])];
    const Vector3 area =
        (dart[static_cast<std::size_t>(t[1])] - a).cross(dart[static_cast<std::size_t>(t[2])] - a);
    EXPECT_LT(area.x(), 0.0);
    sum += area;
  }
  EXPECT_NEAR(sum.x(), -2.0, 1e-12);
}

TEST(Face, BecomesAFanWhenItHasNoPlane) {
  EXPECT_EQ(triangulate_face(std::vector<Vector3>(5, Vector3::Zero())).size(), 3u);
  EXPECT_TRUE(triangulate_face({{0, 0, 0}, {1, 0, 0}}).empty());
}

}  // namespace
}  // namespace prehend
