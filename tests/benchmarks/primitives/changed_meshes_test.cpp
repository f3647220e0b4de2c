// Changes of meshes, and distances between sets of primitives, in closed form.
#include "benchmarks/primitives/changed_meshes.h"

#include <cmath>

#include <gtest/gtest.h>

#include "benchmarks/primitives/primitive_sets.h"
#include "sim/shape/basic_shapes.h"
#include "sim/shape/mesh_checks.h"

namespace prehend::bench {
namespace {

TEST(ChangedMeshes, ShortEdgesKeepTheSurface) {
  const TriangleMesh box = make_box({1.0, 2.0, 3.0});
  const TriangleMesh fine = with_short_edges(box, 0.3);
  EXPECT_NEAR(surface_area(fine), surface_area(box), 1e-12);
  EXPECT_TRUE(check_mesh(fine).closed());
  for (const Triangle& t : fine.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3& a = fine.vertices[static_cast<std::size_t>(t[k])];
      const Vector3& b = fine.vertices[static_cast<std::size_t>(t[(k + 1) % 3])];
      EXPECT_LE((a - b).norm(), 0.3);
    }
  }
}

TEST(ChangedMeshes, NoiseIsAsLargeAsAskedFor) {
  const TriangleMesh ball = make_sphere(1.0, 5);
  Random random(1);
  const TriangleMesh noisy = with_noise(ball, 0.01, random);
  double squares = 0.0;
  for (const Vector3& p : noisy.vertices) squares += (p.norm() - 1.0) * (p.norm() - 1.0);
  EXPECT_NEAR(std::sqrt(squares / static_cast<double>(noisy.vertices.size())), 0.01, 5e-4);
}

TEST(ChangedMeshes, HolesAreAsLargeAsAskedFor) {
  const TriangleMesh ball = make_sphere(1.0, 5);
  Random random(2);
  const TriangleMesh holed = with_holes(ball, 5, 0.1, random);
  EXPECT_NEAR(surface_area(holed) / surface_area(ball), 0.9, 0.005);
}

// Of a cube that is seen along a diagonal three faces; of a ball behind a larger one nothing.
TEST(ChangedMeshes, WhatIsHiddenIsNotSeen) {
  const TriangleMesh cube = with_short_edges(make_box({1.0, 1.0, 1.0}), 0.05);
  const TriangleMesh seen = seen_from(cube, Vector3(1.0, 1.0, 1.0).normalized());
  EXPECT_NEAR(surface_area(seen), 3.0, 0.02);
  TriangleMesh two = make_sphere(1.0, 5);
  append(two, transformed(make_sphere(0.5, 4), translation({0.0, 0.0, -3.0})));
  EXPECT_GT(bounds(seen_from(two, Vector3::UnitZ())).lower.z(), -0.1);
}

TEST(ChangedMeshes, ClustersAreFewerAndStayNear) {
  const TriangleMesh ball = make_sphere(1.0, 5);
  const TriangleMesh coarse = clustered(ball, 0.2);
  EXPECT_LT(coarse.triangles.size(), ball.triangles.size() / 4);
  EXPECT_NEAR(surface_area(coarse), surface_area(ball), 0.05 * surface_area(ball));
}

TEST(PrimitiveSets, DistanceDoesNotDependOnOrderOrTurn) {
  const Primitive ball{Sphere{0.1}, translation({0.5, 0.0, 0.0})};
  const Primitive tube{Cylinder{0.05, 0.2}, Pose::Identity()};
  Primitive turned = tube;
  turned.X_OP.linear() = Eigen::AngleAxisd(1.0, Vector3::UnitZ()).toRotationMatrix();
  EXPECT_NEAR(distance_between({ball, tube}, {turned, ball}), 0.0, 1e-12);
  EXPECT_NEAR(distance_between({ball}, {{Sphere{0.11}, ball.X_OP}}), 0.01, 1e-9);
  EXPECT_EQ(kinds_text({ball, tube, tube}), "2 cylinder + sphere");
}

TEST(PrimitiveSets, MovedWithTheObject) {
  const Primitive tube{Cylinder{0.05, 0.2}, translation({0.1, 0.0, 0.0})};
  Random random(3);
  const Pose X_NO = random.pose(0.5);
  const Primitive moved = moved_primitives({tube}, X_NO, 2.0).front();
  const Vector3 p_O(0.02, 0.3, 0.1);
  EXPECT_NEAR(signed_distance(moved, 2.0 * (X_NO * p_O)), 2.0 * signed_distance(tube, p_O), 1e-12);
}

TEST(PrimitiveSets, ResidualOfALargerBall) {
  const SurfaceResidual residual =
      residual_of(make_sphere(1.0, 6), {{Sphere{1.02}, Pose::Identity()}});
  EXPECT_NEAR(residual.median, 0.02, 1e-3);
  EXPECT_NEAR(residual.percentile_95, 0.02, 1e-3);
}

}  // namespace
}  // namespace prehend::bench
