#include "sim/shape/surface_part.h"

#include <gtest/gtest.h>

#include "sim/shape/convex_hull.h"
#include "sim/shape/mesh_checks.h"
#include "tests/support/test_meshes.h"

namespace prehend {
namespace {

Bounds box_around(const std::vector<Vector3>& points) {
  Bounds box;
  for (const Vector3& p : points) {
    box.lower = box.lower.cwiseMin(p);
    box.upper = box.upper.cwiseMax(p);
  }
  return box;
}

TEST(SurfacePart, ABoxIsCutInTwoBoxes) {
  const SurfacePart part = surface_part(make_box({0.2, 0.1, 0.1}, 3));
  const CutPlane plane{Vector3::UnitX(), 0.05};
  const auto sides = cut(part, plane);
  EXPECT_NEAR(signed_volume(convex_hull(sides[0].corners)), 0.15 * 0.01, 1e-12);
  EXPECT_NEAR(signed_volume(convex_hull(sides[1].corners)), 0.05 * 0.01, 1e-12);
  // The points alone are the same.
  const auto points = cut_points(part, plane, 1000);
  for (std::size_t side = 0; side < 2; ++side) {
    EXPECT_EQ(points[side].size(), sides[side].corners.size());
    EXPECT_LT((box_around(points[side]).size() - box_around(sides[side].corners).size()).norm(),
              1e-15);
  }
}

// A cut along a face takes nothing of it to the other side.
TEST(SurfacePart, AFaceInThePlaneBelongsToItsSolid) {
  const SurfacePart part = surface_part(make_box({0.2, 0.1, 0.1}));
  for (const double sign : {-1.0, 1.0}) {
    const auto sides = cut(part, {sign * Vector3::UnitX(), 0.1});
    EXPECT_EQ(sides[0].ends.size(), 12U);
    EXPECT_TRUE(sides[1].empty());
    EXPECT_TRUE(cut_points(part, {sign * Vector3::UnitX(), 0.1}, 1000)[1].empty());
  }
}

TEST(SurfacePart, OnlyPartsWhoseBoxesAreApartAreSeparate) {
  TriangleMesh mesh = make_sphere(0.01);
  append(mesh, test::moved(make_sphere(0.01), {0.03, 0.0, 0.0}));
  append(mesh, test::moved(make_sphere(0.005), {0.03, 0.0, 0.0}));  // inside the second
  const std::vector<SurfacePart> parts = separate_parts(surface_part(mesh));
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[1].ends.size(), 2 * parts[0].ends.size());
}

}  // namespace
}  // namespace prehend
