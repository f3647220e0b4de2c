// The shapes around a mesh contain each of its triangles, and what is said to be inside is inside.
#include "sim/shape/cover_shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "sim/base/random.h"
#include "sim/shape/basic_shapes.h"
#include "sim/shape/object_generator.h"
#include "sim/shape/proximity.h"

namespace prehend {
namespace {

// Distance of a point from the sum of box and disc of a shape, scaled; by the definition of the
// sum, the nearest point of the box takes the disc along its plane.
double beyond(const CoverShape& shape, double scale, const Vector3& p_M) {
  const Vector3 p = shape.X_MS.inverse() * p_M;
  Vector3 out = (p.cwiseAbs() - scale * shape.half).cwiseMax(0.0);
  const double beside = std::hypot(out.x(), out.y());
  return std::hypot(std::max(0.0, beside - scale * shape.disc), out.z()) - scale * shape.ball;
}

// Points of all triangles: corners, and some between them.
void expect_covered(const TriangleMesh& mesh, const ShapeCover& cover, Random& random) {
  const auto is_covered = [&](const Vector3& p) {
    return std::any_of(cover.shapes.begin(), cover.shapes.end(),
                       [&](const CoverShape& shape) { return beyond(shape, 1.0, p) <= 1e-12; });
  };
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Corners c = corners_of(mesh, static_cast<int>(t));
    for (const Vector3& p : c) ASSERT_TRUE(is_covered(p));
    for (int i = 0; i < 20; ++i) {
      const double u = random.uniform(0.0, 1.0);
      const double v = random.uniform(0.0, 1.0 - u);
      ASSERT_TRUE(is_covered(c[0] + u * (c[1] - c[0]) + v * (c[2] - c[0])));
    }
  }
}

// A point is in the solid or on its surface, up to rounding.
void expect_in_solid(const ProximityMesh& mesh, const Vector3& p) {
  const Vector3 middle = mesh.ball_center();
  EXPECT_TRUE(is_inside(mesh, middle + (p - middle) * (1.0 - 1e-6)) || is_inside(mesh, p));
}

void expect_inside(const ProximityMesh& mesh, const ShapeCover& cover, Random& random) {
  for (const InnerBall& ball : cover.inside) {
    if (ball.radius == 0.0) continue;
    for (int i = 0; i < 20; ++i)
      expect_in_solid(mesh, ball.center + ball.radius * (1.0 - 1e-6) * random.direction());
  }
  for (const CoverShape& shape : cover.shapes) {
    if (shape.inside == 0.0) continue;
    for (int i = 0; i < 100; ++i) {
      const Vector3 at = random.in_box(1.0);
      const double angle = random.uniform(0.0, 2.0 * std::numbers::pi);
      const Vector3 p_S = shape.half.cwiseProduct(at) +
                          shape.disc * Vector3(std::cos(angle), std::sin(angle), 0.0) +
                          shape.ball * random.direction();
      expect_in_solid(mesh, shape.X_MS * (shape.inside * (1.0 - 1e-6) * p_S));
    }
  }
}

TriangleMesh turned(const TriangleMesh& mesh, Random& random) {
  const Vector3 by = random.in_box(0.3);
  return transformed(mesh, pose_from(random.rotation(), by));
}

TEST(CoverShapes, OfSimpleShapesAreTheseShapes) {
  Random random(1);
  for (int i = 0; i < 5; ++i) {
    const ShapeCover box = cover_of(ProximityMesh(turned(make_box({0.1, 0.2, 0.3}), random)));
    ASSERT_EQ(box.shapes.size(), 1U);
    Vector3 half = box.shapes[0].half;
    std::sort(half.begin(), half.end());
    EXPECT_TRUE(half.isApprox(Vector3(0.05, 0.1, 0.15), 1e-6));
    EXPECT_EQ(box.shapes[0].disc + box.shapes[0].ball, 0.0);
    EXPECT_NEAR(box.shapes[0].inside, 1.0, 1e-6);

    constexpr int kSides = 24;
    const ShapeCover can =
        cover_of(ProximityMesh(turned(make_cylinder(0.03, 0.2, kSides), random)));
    ASSERT_EQ(can.shapes.size(), 1U);
    EXPECT_NEAR(can.shapes[0].half.z(), 0.1, 1e-7);
    EXPECT_NEAR(can.shapes[0].disc, 0.03, 1e-7);
    // The sides of a regular polygon are this much nearer than its corners.
    EXPECT_NEAR(can.shapes[0].inside, std::cos(std::numbers::pi / kSides), 1e-6);

    const ShapeCover ball = cover_of(ProximityMesh(turned(make_sphere(0.04, 2), random)));
    ASSERT_EQ(ball.shapes.size(), 1U);
    EXPECT_NEAR(ball.shapes[0].ball, 0.04, 1e-3);
    EXPECT_LT(ball.shapes[0].half.norm(), 1e-3);
    EXPECT_GT(ball.shapes[0].inside, 0.9);
  }
}

TEST(CoverShapes, ContainAllTrianglesAndFillNoMoreThanTheSolid) {
  Random random(2);
  for (const std::string& name : generated_object_names()) {
    SCOPED_TRACE(name);
    const ProximityMesh mesh(turned(generate_object(name, 600), random));
    const ShapeCover& cover = cover_of(mesh);
    expect_covered(mesh.mesh(), cover, random);
    expect_inside(mesh, cover, random);
  }
}

TEST(CoverShapes, OfSeveralComponentsAreOneEach) {
  Random random(3);
  TriangleMesh mesh = make_box({0.1, 0.1, 0.1});
  append(mesh, transformed(make_cylinder(0.02, 0.3, 16), translation({0.1, 0.0, 0.0})));
  append(mesh, transformed(make_box({0.02, 0.3, 0.05}), translation({0.0, 0.3, 0.1})));
  const ProximityMesh of(turned(mesh, random));
  const ShapeCover& cover = cover_of(of);
  EXPECT_EQ(cover.shapes.size(), 3U);
  expect_covered(of.mesh(), cover, random);
  expect_inside(of, cover, random);
}

TEST(CoverShapes, OfASurfaceWithoutVolumeAreBoxes) {
  Random random(4);
  TriangleMesh soup;
  for (int i = 0; i < 200; ++i) {
    const int first = static_cast<int>(soup.vertices.size());
    const Vector3 at = random.in_box(0.5);
    for (int k = 0; k < 3; ++k) soup.vertices.push_back(at + random.in_box(0.05));
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  const ProximityMesh mesh(soup);
  const ShapeCover& cover = cover_of(mesh);
  EXPECT_GT(cover.shapes.size(), 1U);
  expect_covered(soup, cover, random);
  for (const CoverShape& shape : cover.shapes) EXPECT_EQ(shape.inside, 0.0);
}

TEST(CoverShapes, ReachAsFarAsTheyAre) {
  const CoverShape box{Pose::Identity(), {1.0, 2.0, 3.0}};
  EXPECT_DOUBLE_EQ(box.extent(Vector3::UnitY()), 2.0);
  EXPECT_DOUBLE_EQ(box.extent(Vector3(2.0, -1.0, 2.0) / 3.0), 10.0 / 3.0);
  const CoverShape cylinder{Pose::Identity(), {0.0, 0.0, 3.0}, 2.0};
  EXPECT_DOUBLE_EQ(cylinder.extent(Vector3(0.6, 0.0, -0.8)), 0.6 * 2.0 + 0.8 * 3.0);
  const CoverShape capsule{Pose::Identity(), {0.0, 0.0, 3.0}, 0.0, 2.0};
  EXPECT_DOUBLE_EQ(capsule.extent(Vector3(0.6, 0.0, -0.8)), 2.0 + 0.8 * 3.0);
}

}  // namespace
}  // namespace prehend
