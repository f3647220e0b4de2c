#include "sim/soft/limit_surface.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "sim/base/random.h"

namespace prehend {
namespace {

// Points all over a disc that bear the same.
std::vector<PressedPoint> disc(double radius, int rings) {
  std::vector<PressedPoint> points;
  for (int i = 0; i < rings; ++i) {
    const double r = radius * std::sqrt((i + 0.5) / rings);  // rings of equal area
    for (int k = 0; k < 60; ++k) {
      const double angle = 2.0 * std::numbers::pi * (k + 0.5 * (i % 2)) / 60;
      points.push_back({{r * std::cos(angle), r * std::sin(angle), 0.0}, Vector3::UnitZ(), 1.0});
    }
  }
  return points;
}

TEST(LimitSurface, OfAUniformDiscHasTwoThirdsOfTheRadiusAsArm) {
  const LimitSurface surface = limit_surface(disc(0.006, 40));
  EXPECT_NEAR(surface.torsion, 2.0 / 3.0 * 0.006, 1e-3 * 0.006);
  EXPECT_NEAR(surface.load, 40 * 60, 1e-9);
  EXPECT_LT(surface.center.norm(), 1e-12);
}

TEST(LimitSurface, OfARingIsItsRadius) {
  const LimitSurface surface = limit_surface(disc(0.005 * std::numbers::sqrt2, 1));
  EXPECT_NEAR(surface.torsion, 0.005, 1e-12);
}

TEST(LimitSurface, OfAPointHasNoTorsion) {
  const std::vector<PressedPoint> point{{Vector3(1, 2, 3), Vector3::UnitX(), 4.0}};
  const LimitSurface surface = limit_surface(point);
  EXPECT_EQ(surface.torsion, 0.0);
  EXPECT_EQ(surface.fitted_torsion, 0.0);
  EXPECT_EQ(surface.center, Vector3(1, 2, 3));
  EXPECT_EQ(surface.load, 4.0);
}

// No load lies outside of what friction bears: at most 1 as a force, at most the torsion as a
// torque, and no motion is done with more power than another load of the surface would give
// (convexity).
TEST(LimitSurface, IsConvexAndInsideItsBounds) {
  Random random(11);
  std::vector<PressedPoint> points;
  for (int i = 0; i < 30; ++i) {
    points.push_back({{random.uniform(-1, 1) * 1e-2, random.uniform(-1, 1) * 4e-3, 0.0},
                      Vector3::UnitZ(),
                      random.uniform(0, 1)});
  }
  const LimitSurface surface = limit_surface(points);
  const std::vector<LimitLoad> loads = limit_loads(points, surface, 20);
  for (const LimitLoad& load : loads) {
    EXPECT_LE(load.force.norm(), 1.0 + 1e-12);
    EXPECT_LE(std::abs(load.torque), surface.torsion * (1.0 + 1e-12));
  }
  EXPECT_GT(surface.error, 0.0);
  EXPECT_LT(surface.error, 0.3);
  EXPECT_NEAR(surface.fitted_torsion, surface.torsion, 0.2 * surface.torsion);
}

}  // namespace
}  // namespace prehend
