#include "primitives/surface_sample.h"

#include <gtest/gtest.h>

#include "sim/shape/object_generator.h"
#include "tests/primitives/test_meshes.h"

namespace prehend {
namespace {

TEST(SampleSurface, EachFaceGetsItsShareOfTheArea) {
  const Vector3 size(1.0, 2.0, 5.0);
  constexpr int kCount = 3000;
  for (const int cells : {1, 7}) {
    const auto points = sample_surface(make_box(size, cells), kCount, 1);
    ASSERT_EQ(points.size(), static_cast<std::size_t>(kCount));
    const double area = 2.0 * (2.0 + 10.0 + 5.0);
    for (int axis = 0; axis < 3; ++axis) {
      const double expected = kCount * size.prod() / size[axis] / area;
      const auto on_face = std::count_if(points.begin(), points.end(), [&](const SurfacePoint& s) {
        return s.p_O[axis] > 0.5 * size[axis] - 1e-9;
      });
      // Stretches of the running area are split between faces at their ends only.
      EXPECT_NEAR(static_cast<double>(on_face), expected, 2.0 * cells * cells + 2.0);
    }
  }
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
  int moved = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].p_O, b[i].p_O);
    moved += a[i].p_O != c[i].p_O;
  }
  EXPECT_EQ(moved, 100);
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
