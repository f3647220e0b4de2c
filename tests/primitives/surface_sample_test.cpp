#include "primitives/surface_sample.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "sim/base/random.h"
#include "sim/shape/basic_shapes.h"
#include "sim/shape/object_generator.h"
#include "tests/primitives/test_meshes.h"

namespace prehend {
namespace {

TEST(SampleSurface, EachFaceGetsItsShareOfTheArea) {
  Random random(161);
  const Vector3 size(1.0, 2.0, 5.0);
  constexpr int kCount = 3000;
  for (int i = 0; i < 20; ++i) {
    const Pose X_OB = i == 0 ? Pose(Pose::Identity()) : random.pose(1.0);
    const Pose X_BO = X_OB.inverse();
    const auto points = sample_surface(transformed(make_box(size, 1 + i), X_OB), kCount, 1);
    EXPECT_NEAR(static_cast<double>(points.size()), kCount, 0.04 * kCount);
    const double area = 2.0 * (2.0 + 10.0 + 5.0);
    for (int axis = 0; axis < 3; ++axis) {
      const double expected = kCount * size.prod() / size[axis] / area;
      const auto on_face = std::count_if(points.begin(), points.end(), [&](const SurfacePoint& s) {
        return (X_BO * s.p_O)[axis] > 0.5 * size[axis] - 1e-9;
      });
      // Lines near the sides of a face are on it or not: a part of its circumference.
      const double sides = 2.0 * (size.sum() - size[axis]);
      const double spacing = std::sqrt(area / kCount);
      EXPECT_NEAR(static_cast<double>(on_face), expected, 0.5 * sides / spacing);
    }
  }
}

// Nothing but rounding: lines that meet an edge may count for either side.
TEST(SampleSurface, DependsOnTheSurfaceAndNotOnItsTriangles) {
  const TriangleMesh mug = generate_object("mug", 2000);
  TriangleMesh finer = test::subdivided(mug);
  std::reverse(finer.triangles.begin(), finer.triangles.end());
  const auto points = sample_surface(mug, 2000, 1);
  const auto same = sample_surface(finer, 2000, 1);
  ASSERT_EQ(points.size(), same.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_LT((points[i].p_O - same[i].p_O).norm(), 1e-12);
  }
}

TEST(SampleSurface, TurnsWithTheMeshAndTheAxes) {
  Random random(162);
  const TriangleMesh mug = generate_object("mug", 2000);
  const auto points = sample_surface(mug, 2000, 1);
  for (int i = 0; i < 10; ++i) {
    const Pose X_NO = random.pose(1.0);
    const auto turned = sample_surface(transformed(mug, X_NO), 2000, 1, X_NO.linear());
    ASSERT_EQ(points.size(), turned.size());
    for (std::size_t k = 0; k < points.size(); ++k) {
      EXPECT_LT((turned[k].p_O - X_NO * points[k].p_O).norm(), 1e-9);
    }
  }
}

TEST(SampleSurface, FindsSomethingOfANeedle) {
  const TriangleMesh needle{{{0, 0, 0}, {1, 0, 0}, {1, 1e-13, 0}}, {{0, 1, 2}}};
  EXPECT_FALSE(sample_surface(needle, 100, 1).empty());
}

TEST(SampleSurface, NormalsPointOutwardsAlsoForAnInsideOutMesh) {
  TriangleMesh sphere = make_sphere(1.0, 3);
  for (const bool inside_out : {false, true}) {
    if (inside_out) {
      for (Triangle& t : sphere.triangles) std::swap(t[0], t[1]);
    }
    for (const SurfacePoint& s : sample_surface(sphere, 500, 1)) {
      EXPECT_GT(s.n_O.dot(s.p_O.normalized()), 0.9);
      EXPECT_NEAR(s.n_O.norm(), 1.0, 1e-12);
    }
  }
}

TEST(SampleSurface, SameSeedSameBytesOtherSeedOtherPoints) {
  const TriangleMesh mesh = make_cylinder(1.0, 2.0);
  const auto a = sample_surface(mesh, 100, 5);
  const auto b = sample_surface(mesh, 100, 5);
  const auto c = sample_surface(mesh, 100, 6);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].p_O, b[i].p_O);
  const auto is_in_a = [&](const SurfacePoint& s) {
    return std::any_of(a.begin(), a.end(), [&](const SurfacePoint& o) { return o.p_O == s.p_O; });
  };
  EXPECT_TRUE(std::none_of(c.begin(), c.end(), is_in_a));
}

TEST(SampleSurface, AMeshWithoutAreaGivesNoPoints) {
  TriangleMesh line;
  line.vertices = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {2.0, 0.0, 0.0}};
  line.triangles = {{0, 1, 2}};
  EXPECT_TRUE(sample_surface(line, 10, 1).empty());
  EXPECT_TRUE(sample_surface({}, 10, 1).empty());
}

}  // namespace
}  // namespace prehend
