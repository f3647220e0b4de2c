#include "primitives/smoothed_points.h"

#include <gtest/gtest.h>

#include "sim/shape/make_mesh.h"
#include "tests/primitives/test_meshes.h"

namespace prehend {
namespace {

constexpr double kReach = 0.045;

// Distances from a sphere of this radius, in the root of their mean square.
double roughness(const std::vector<SurfacePoint>& points, double radius) {
  double sum = 0.0;
  for (const SurfacePoint& s : points) {
    const double off = s.p_O.norm() - radius;
    sum += off * off;
  }
  return std::sqrt(sum / static_cast<double>(points.size()));
}

TEST(SmoothedPoints, NoiseOfASphereBecomesSmall) {
  Random random(3);
  const TriangleMesh mesh = test::disturbed(make_sphere(0.289, 5), 0.01, random);
  const std::vector<SurfacePoint> rough = sample_surface(mesh, 12000, 1);
  const std::vector<SurfacePoint> smooth = smoothed_points(rough, kReach, 3000).smooth;
  EXPECT_NEAR(static_cast<double>(smooth.size()), 3000.0, 30.0);
  EXPECT_LT(roughness(smooth, 0.289), 0.5 * roughness(rough, 0.289));
  double cosines = 0.0;
  for (const SurfacePoint& s : smooth) cosines += s.n_O.dot(s.p_O.normalized());
  EXPECT_GT(cosines / static_cast<double>(smooth.size()), 0.98);
}

// Half of a ball crumpled: its triangles have several times the area, but not the points.
TEST(SmoothedPoints, CrumpledSurfaceGetsNoMorePoints) {
  Random random(4);
  TriangleMesh mesh = make_sphere(0.289, 5);
  for (Vector3& p : mesh.vertices) {
    if (p.z() > 0.0) p += 0.012 * random.direction();
  }
  const auto above = [](const std::vector<SurfacePoint>& points) {
    double count = 0.0;
    for (const SurfacePoint& s : points) count += s.p_O.z() > 0.0 ? 1.0 : 0.0;
    return count / static_cast<double>(points.size());
  };
  const std::vector<SurfacePoint> rough = sample_surface(mesh, 12000, 1);
  EXPECT_GT(above(rough), 0.6);
  EXPECT_NEAR(above(smoothed_points(rough, kReach, 3000).smooth), 0.5, 0.05);
}

// A plate thinner than the radius keeps its thickness, and its edges.
TEST(SmoothedPoints, TheSidesOfAWallDoNotMix) {
  const TriangleMesh mesh = make_box({0.6, 0.6, 0.03}, 20);
  for (const SurfacePoint& s :
       smoothed_points(sample_surface(mesh, 12000, 1), kReach, 3000).smooth) {
    const bool side = s.p_O.head<2>().cwiseAbs().maxCoeff() < 0.3 - kReach;
    if (side) EXPECT_NEAR(std::abs(s.p_O.z()), 0.015, 0.002);
    EXPECT_LT(s.p_O.head<2>().cwiseAbs().maxCoeff(), 0.301);
  }
}

TEST(SmoothedPoints, SameBytesOnAnyNumberOfThreads) {
  Random random(5);
  const TriangleMesh mesh = test::disturbed(make_sphere(0.289, 4), 0.01, random);
  const std::vector<SurfacePoint> points = sample_surface(mesh, 5000, 1);
  const std::vector<SurfacePoint> one = smoothed_points(points, kReach, 1000, 1).smooth;
  const std::vector<SurfacePoint> more = smoothed_points(points, kReach, 1000, 3).smooth;
  ASSERT_EQ(one.size(), more.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].p_O, more[i].p_O);
    EXPECT_EQ(one[i].n_O, more[i].n_O);
  }
}

}  // namespace
}  // namespace prehend
