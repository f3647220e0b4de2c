// Sizes of primitives along directions, compared with those of their surfaces.
#include "planner/plan/learn/primitive_extent.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "sim/base/random.h"

namespace prehend {
namespace {

double spread(const std::vector<Vector3>& points, const Vector3& d) {
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  for (const Vector3& p : points) {
    least = std::min(least, d.dot(p));
    most = std::max(most, d.dot(p));
  }
  return most - least;
}

// Two circles about z, with so many points that their polygons are as large to a thousandth.
std::vector<Vector3> ends(double low, double high, double height) {
  std::vector<Vector3> points;
  for (int i = 0; i < 240; ++i) {
    const double angle = i * std::numbers::pi / 120.0;
    const Vector3 around(std::cos(angle), std::sin(angle), 0.0);
    points.emplace_back(low * around - 0.5 * height * Vector3::UnitZ());
    points.emplace_back(high * around + 0.5 * height * Vector3::UnitZ());
  }
  return points;
}

TEST(PrimitiveExtent, IsThatOfTheSurface) {
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const Pose X_OP = random.pose(0.3);
    const Vector3 d_O = random.direction();
    const Vector3 d = X_OP.linear().transpose() * d_O;
    const double a = random.uniform(0.0, 0.1);
    const double b = random.uniform(0.01, 0.1);
    const double h = random.uniform(0.01, 0.2);
    EXPECT_NEAR(primitive_extent({Sphere{b}, X_OP}, d_O), 2.0 * b, 1e-12);
    EXPECT_NEAR(primitive_extent({Cylinder{b, h}, X_OP}, d_O), spread(ends(b, b, h), d), 1e-3 * b);
    EXPECT_NEAR(primitive_extent({Cone{a, b, h}, X_OP}, d_O), spread(ends(a, b, h), d),
                1e-3 * (a + b));
    const Vector3 size(a, b, h);
    std::vector<Vector3> corners;
    for (int c = 0; c < 8; ++c) {
      corners.emplace_back(0.5 * Vector3(c & 1 ? a : -a, c & 2 ? b : -b, c & 4 ? h : -h));
    }
    EXPECT_NEAR(primitive_extent({Box{size}, X_OP}, d_O), spread(corners, d), 1e-12);
    EXPECT_NEAR(primitive_extent({Bar{corners, 0.01, false}, X_OP}, d_O), spread(corners, d) + 0.01,
                1e-12);
  }
}

}  // namespace
}  // namespace prehend
