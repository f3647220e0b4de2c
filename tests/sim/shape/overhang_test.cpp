#include "sim/shape/overhang.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "sim/base/input_error.h"
#include "sim/base/random.h"
#include "sim/shape/basic_shapes.h"
#include "sim/shape/nearest_point.h"
#include "sim/shape/object_generator.h"

namespace prehend {
namespace {

TEST(OverhangGauge, FindsTheNearestPoint) {
  const TriangleMesh mesh = generate_object("mug", 1000);
  const OverhangGauge gauge(mesh);
  Random random(2);
  for (int i = 0; i < 200; ++i) {
    const Vector3 p = random.in_box({-0.1, -0.1, -0.05}, {0.1, 0.1, 0.15});
    double least = 1e9;
    for (const Triangle& t : mesh.triangles) {
      const auto corner = [&](std::size_t k) {
        return mesh.vertices[static_cast<std::size_t>(t[k])];
      };
      least = std::min(least, (nearest_point_on({corner(0), corner(1), corner(2)}, p) - p).norm());
    }
    const OverhangPoint found = gauge.nearest(p);
    EXPECT_NEAR(found.distance, least, 1e-12);
    EXPECT_NEAR((found.nearest - p).norm(), least, 1e-12);
  }
}

// A larger box around a box: the farthest points are near its corners.
TEST(OverhangGauge, FindsWhatReachesOut) {
  const OverhangGauge gauge(make_box({0.1, 0.1, 0.1}));
  EXPECT_TRUE(gauge.find(make_box({0.1, 0.1, 0.1}), 1e-6, 100).empty());
  EXPECT_TRUE(gauge.find(make_box({0.05, 0.1, 0.08}), 1e-6, 100).empty());
  const auto found = gauge.find(make_box({0.12, 0.12, 0.12}), 1e-3, 20000);
  ASSERT_FALSE(found.empty());
  const double corner = 0.01 * std::sqrt(3.0);
  EXPECT_LE(found.front().distance, corner);
  EXPECT_GT(found.front().distance, 0.9 * corner);
  EXPECT_GE(found.back().distance, 0.01 - 1e-12);
  EXPECT_TRUE(gauge.contains({0.04, 0.0, 0.0}));
  EXPECT_FALSE(gauge.contains({0.06, 0.0, 0.0}));
}

TEST(OverhangGauge, NeedsASurface) { EXPECT_THROW(OverhangGauge({}), InputError); }

}  // namespace
}  // namespace prehend
