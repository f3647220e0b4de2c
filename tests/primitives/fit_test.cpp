// The three fits where part of the surface is missing or does not belong.
#include <gtest/gtest.h>

#include "primitives/fit_shapes.h"
#include "primitives/inscribed.h"
#include "sim/shape/object_generator.h"
#include "tests/primitives/test_meshes.h"

namespace prehend {
namespace {

constexpr int kPoints = 1500;
const FitOptions kOptions{.outlier = 0.08, .min_extent = 1e-4};

// One point in ten replaced by one that lies a third to a half of a unit off to a side.
std::vector<SurfacePoint> with_a_lump(std::vector<SurfacePoint> points, Random& random) {
  const Vector3 at = 0.9 * random.direction();
  for (std::size_t i = 0; i < points.size(); i += 10) {
    points[i].p_O = at + 0.1 * random.direction();
    points[i].n_O = random.direction();
  }
  return points;
}

TEST(FitSphere, IgnoresALump) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Random random(seed);
    const auto points = with_a_lump(sample_surface(make_sphere(0.5, 4), kPoints, seed), random);
    const Primitive found = fit_sphere(points, kOptions);
    EXPECT_NEAR(std::get<Sphere>(found.shape).radius, 0.5, 0.005) << seed;
    EXPECT_LT(found.X_OP.translation().norm(), 0.005) << seed;
  }
}

TEST(FitCylinder, IgnoresALump) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Random random(seed);
    const auto points = with_a_lump(sample_surface(make_cylinder(0.3, 0.9), kPoints, seed), random);
    const Primitive found = fit_cylinder(points, kOptions);
    EXPECT_NEAR(std::get<Cylinder>(found.shape).radius, 0.3, 0.003) << seed;
    EXPECT_NEAR(std::get<Cylinder>(found.shape).height, 0.9, 0.009) << seed;
  }
}

TEST(FitBox, IgnoresALump) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Random random(seed);
    const auto points =
        with_a_lump(sample_surface(make_box({0.3, 0.5, 0.8}), kPoints, seed), random);
    const Primitive found = fit_box(points, kOptions);
    EXPECT_NEAR(std::get<Box>(found.shape).size.prod(), 0.12, 0.005) << seed;
  }
}

// An open end is where the surface ends, to the few points that the robust end leaves out.
TEST(FitCylinder, OpenEndsAreWhereTheSideEnds) {
  const TriangleMesh closed = make_cylinder(0.3, 0.9, 64, 30);
  const TriangleMesh cup = test::without_triangles_above(closed, 0.449);
  const Primitive found = fit_cylinder(sample_surface(cup, kPoints, 1), kOptions);
  EXPECT_NEAR(std::get<Cylinder>(found.shape).radius, 0.3, 0.003);
  EXPECT_NEAR(std::get<Cylinder>(found.shape).height, 0.9, 0.02);
}

TEST(FitBox, AnOpenFaceIsWhereTheSidesEnd) {
  const TriangleMesh tray = test::without_triangles_above(make_box({0.4, 0.5, 0.8}, 20), 0.399);
  const Primitive found = fit_box(sample_surface(tray, kPoints, 1), kOptions);
  EXPECT_NEAR(std::get<Box>(found.shape).size.prod(), 0.16, 0.004);
}

// The inner wall of a cup faces the axis; the cylinder found is the outer one.
TEST(FitCylinder, GoesToTheOuterOfTwoWalls) {
  TriangleMesh cup = make_cylinder(0.3, 0.8, 64, 10);
  TriangleMesh inner = make_cylinder(0.27, 0.74, 64, 10);
  for (Triangle& t : inner.triangles) std::swap(t[0], t[1]);
  append(cup, inner);
  const Primitive found = fit_cylinder(sample_surface(cup, kPoints, 1), kOptions);
  EXPECT_NEAR(std::get<Cylinder>(found.shape).radius, 0.3, 0.004);
}

// A flat-sided prism of 16 sides lies up to 2 % inside of the cylinder through its vertices.
TEST(OnVertices, MeasuresRadiiAtTheVertices) {
  const TriangleMesh prism = make_cylinder(0.4, 0.5, 16);
  const auto points = sample_surface(prism, kPoints, 1);
  const Primitive fitted = fit_cylinder(points, kOptions);
  EXPECT_LT(std::get<Cylinder>(fitted.shape).radius, 0.3985);
  const Primitive found = on_vertices(fitted, points, prism);
  EXPECT_NEAR(std::get<Cylinder>(found.shape).radius, 0.4, 1e-4);
}

TEST(FitAll, APointATriangleAndAPlateGiveFiniteShapes) {
  for (const std::size_t count : {1U, 2U, 3U, 200U}) {
    Random random(9);
    std::vector<SurfacePoint> points(count);
    for (SurfacePoint& s : points) {
      s.p_O = {random.uniform(0.0, 1.0), random.uniform(0.0, 1.0), 0.0};
      s.n_O = Vector3::UnitZ();
    }
    for (const Primitive& found : {fit_box(points, kOptions), fit_cylinder(points, kOptions),
                                   fit_sphere(points, kOptions)}) {
      EXPECT_TRUE(found.X_OP.matrix().allFinite()) << shape_name(found.shape) << count;
      EXPECT_GT(surface_area(found.shape), 0.0) << shape_name(found.shape) << count;
      EXPECT_LT(surface_area(found.shape), 1e3) << shape_name(found.shape) << count;
    }
  }
}

}  // namespace
}  // namespace prehend
