#include "sim/shape/basic_shapes.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "sim/base/input_error.h"
#include "tests/support/test_meshes.h"

namespace prehend {
namespace {

using test::expect_outward_solid;

TEST(Box, HasTwelveTrianglesAndTheProductOfItsSides) {
  const TriangleMesh box = make_box({0.1, 0.2, 0.3});
  EXPECT_EQ(box.triangles.size(), 12u);
  EXPECT_EQ(box.vertices.size(), 8u);
  expect_outward_solid(box);
  EXPECT_NEAR(signed_volume(box), 0.006, 1e-15);
  EXPECT_TRUE(bounds(box).center().isZero(1e-15));
}

TEST(Box, CellsChangeNeitherVolumeNorArea) {
  for (const int cells : {2, 3, 7}) {
    const TriangleMesh box = make_box({0.1, 0.2, 0.3}, cells);
    EXPECT_EQ(box.triangles.size(), 12u * static_cast<unsigned>(cells * cells));
    expect_outward_solid(box);
    EXPECT_NEAR(signed_volume(box), 0.006, 1e-15);
    EXPECT_NEAR(surface_area(box), 0.22, 1e-14);
  }
}

TEST(Cylinder, IsThePrismOverARegularPolygon) {
  for (const int sides : {3, 12, 48}) {
    for (const int rings : {1, 4}) {
      const TriangleMesh cylinder = make_cylinder(0.05, 0.2, sides, rings);
      expect_outward_solid(cylinder);
      const double base = 0.5 * sides * 0.05 * 0.05 * std::sin(2.0 * std::numbers::pi / sides);
      EXPECT_NEAR(signed_volume(cylinder), base * 0.2, 1e-15);
    }
  }
}

TEST(Sphere, VerticesAreOnItAndVolumeConvergesWithTheSquareOfTheEdge) {
  const double exact = 4.0 / 3.0 * std::numbers::pi * 0.001;
  double previous = exact;
  for (int n = 0; n <= 5; ++n) {
    const TriangleMesh ball = make_sphere(0.1, n);
    EXPECT_EQ(ball.triangles.size(), 20u << (2 * n));
    EXPECT_EQ(test::euler_characteristic(ball), 2);
    expect_outward_solid(ball);
    for (const Vector3& p : ball.vertices) ASSERT_NEAR(p.norm(), 0.1, 1e-15);
    const double missing = exact - signed_volume(ball);
    EXPECT_GT(missing, 0.0);
    if (n >= 3) {
      EXPECT_NEAR(previous / missing, 4.0, 0.2);
    }
    previous = missing;
  }
}

TEST(Prism, OverAConcavePolygonHasItsAreaTimesItsHeight) {
  // An L of area 3.
  const std::vector<Eigen::Vector2d> l{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  const TriangleMesh prism = make_prism(l, -1.0, 0.5);
  expect_outward_solid(prism);
  EXPECT_EQ(prism.triangles.size(), 2u * 4u + 12u);
  EXPECT_NEAR(signed_volume(prism), 4.5, 1e-14);
  EXPECT_EQ(bounds(prism).lower.z(), -1.0);
  EXPECT_EQ(bounds(prism).upper.z(), 0.5);
}

TEST(Shapes, RefuseSizesThatAreNotPositiveAndNameThem) {
  EXPECT_THROW(make_box({1.0, 0.0, 1.0}), InputError);
  EXPECT_THROW(make_box({1.0, 1.0, 1.0}, 0), InputError);
  EXPECT_THROW(make_cylinder(1.0, -1.0), InputError);
  EXPECT_THROW(make_cylinder(1.0, 1.0, 2), InputError);
  EXPECT_THROW(make_sphere(std::nan("")), InputError);
  EXPECT_THROW(make_sphere(1.0, 9), InputError);
  EXPECT_THROW(make_prism({{0, 0}, {0, 1}, {1, 0}}, 0.0, 1.0), InputError);          // clockwise
  EXPECT_THROW(make_prism({{0, 0}, {1, 1}, {1, 0}, {0, 1}}, 0.0, 1.0), InputError);  // crossing
  EXPECT_THROW(make_prism({{0, 0}, {1, 0}, {0, 1}}, 1.0, 1.0), InputError);
  try {
    make_cylinder(-2.0, 1.0);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(
        std::string(error.what()).find("cylinder radius: must be above 0 and at most 2e6 m (-2)"),
        std::string::npos);
  }
}

}  // namespace
}  // namespace prehend
