#include "sim/shape/nearest_point.h"

#include <algorithm>
#include <array>

#include <gtest/gtest.h>

#include "sim/base/random.h"

namespace prehend {
namespace {

// Against a fine grid of points of the triangle, which can only be farther away.
TEST(NearestPoint, IsNoFartherThanAnyPointOfTheTriangle) {
  Random random(5);
  for (int i = 0; i < 200; ++i) {
    const std::array<Vector3, 3> triangle{random.in_box(1.0), random.in_box(1.0),
                                          random.in_box(1.0)};
    const Vector3 p = random.in_box(2.0);
    const double distance = (nearest_point_on(triangle, p) - p).norm();
    double least = 1e9;
    constexpr int kSteps = 60;
    for (int s = 0; s <= kSteps; ++s) {
      for (int t = 0; s + t <= kSteps; ++t) {
        const double u = static_cast<double>(s) / kSteps;
        const double v = static_cast<double>(t) / kSteps;
        const Vector3 q = (1.0 - u - v) * triangle[0] + u * triangle[1] + v * triangle[2];
        least = std::min(least, (q - p).norm());
      }
    }
    ASSERT_LE(distance, least + 1e-12);
    ASSERT_GE(distance, least - 3.0 / kSteps);
  }
}

TEST(NearestPoint, OfATriangleWithoutAreaIsOnItsEdges) {
  const Vector3 a(0, 0, 0);
  const Vector3 b(1, 0, 0);
  EXPECT_EQ(nearest_point_on({a, b, b}, {0.25, 1, 0}), Vector3(0.25, 0, 0));
  EXPECT_EQ(nearest_point_on({a, a, a}, {0.25, 1, 0}), a);
}

}  // namespace
}  // namespace prehend
