#include "sim/shape/sphere_cover.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "sim/base/random.h"
#include "sim/shape/basic_shapes.h"
#include "sim/shape/nearest_point.h"
#include "sim/shape/object_generator.h"
#include "sim/shape/proximity.h"

namespace prehend {
namespace {

double brute_distance(const TriangleMesh& mesh, const Vector3& p) {
  double least = INFINITY;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vector3 q = nearest_point_on(corners_of(mesh, static_cast<int>(t)), p);
    least = std::min(least, (q - p).norm());
  }
  return least;
}

Vector3 random_point_on(const TriangleMesh& mesh, Random& random) {
  const auto t = static_cast<int>(random.uniform() * static_cast<double>(mesh.triangles.size()));
  const Corners c = corners_of(mesh, t);
  double a = random.uniform();
  double b = random.uniform();
  if (a + b > 1.0) {
    a = 1.0 - a;
    b = 1.0 - b;
  }
  return c[0] + a * (c[1] - c[0]) + b * (c[2] - c[0]);
}

// Every point of the surface is in a sphere, and no point of a sphere is farther out than `error`.
void expect_cover(const TriangleMesh& mesh, double error, const std::string& name) {
  SCOPED_TRACE(name);
  const ProximityMesh body(mesh);
  const std::vector<CoverSphere> spheres = sphere_cover(body, error);
  Random random(5);
  for (int i = 0; i < 2000; ++i) {
    const Vector3 p = random_point_on(mesh, random);
    ASSERT_TRUE(std::any_of(spheres.begin(), spheres.end(), [&](const CoverSphere& sphere) {
      return (p - sphere.center_M).norm() <= sphere.radius;
    })) << p.transpose();
  }
  for (int i = 0; i < 500; ++i) {
    const CoverSphere& sphere = spheres[static_cast<std::size_t>(i) % spheres.size()];
    const Vector3 p = sphere.center_M + sphere.radius * random.direction();
    if (is_inside(body, p)) continue;
    ASSERT_LE(brute_distance(mesh, p), error * (1.0 + 1e-9)) << p.transpose();
  }
  for (std::size_t i = 1; i < spheres.size(); ++i) {
    EXPECT_LE(spheres[i].radius, spheres[i - 1].radius);
  }
}

TEST(SphereCover, HoldsTheSurfaceAndReachesLittleOutOfTheBody) {
  expect_cover(make_box({0.1, 0.06, 0.02}), 0.012, "box");
  expect_cover(generate_object("ball", 600), 0.012, "ball");
  expect_cover(generate_object("mug", 1500), 0.012, "mug");
  expect_cover(generate_object("wine_glass", 1500), 0.015, "wine_glass");
}

// What encloses nothing has no point inside.
TEST(SphereCover, OfASheetHasItsCentersOnTheSheet) {
  const TriangleMesh sheet{{{0, 0, 0}, {0.1, 0, 0}, {0.1, 0.08, 0}, {0, 0.08, 0}},
                           {{0, 1, 2}, {0, 2, 3}}};
  expect_cover(sheet, 0.01, "sheet");
  for (const CoverSphere& sphere : sphere_cover(ProximityMesh(sheet), 0.01)) {
    EXPECT_EQ(sphere.radius, 0.01);
    EXPECT_EQ(sphere.center_M.z(), 0.0);
  }
}

// A ball is one sphere where the grid has a point near its middle; a smaller error needs more.
TEST(SphereCover, NeedsFewSpheresForALargeErrorAndMoreForASmallerOne) {
  const ProximityMesh ball(generate_object("ball", 600));
  const double radius = ball.ball_radius();
  EXPECT_EQ(sphere_cover(ball, 0.3 * radius).size(), 1U);
  const ProximityMesh box(make_box({0.2, 0.2, 0.2}));
  EXPECT_GT(sphere_cover(box, 0.03).size(), 2 * sphere_cover(box, 0.06).size());
}

}  // namespace
}  // namespace prehend
