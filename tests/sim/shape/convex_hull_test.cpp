#include "sim/shape/convex_hull.h"

#include <limits>

#include <gtest/gtest.h>

#include "sim/base/random.h"
#include "sim/shape/object_generator.h"
#include "tests/support/test_meshes.h"

namespace prehend {
namespace {

// No point may be above a face by more than rounding.
void expect_around(const TriangleMesh& hull, const std::vector<Vector3>& points, double slack) {
  test::expect_outward_solid(hull);
  EXPECT_EQ(test::euler_characteristic(hull), 2);
  for (std::size_t t = 0; t < hull.triangles.size(); ++t) {
    const Vector3 normal = doubled_area_vector(hull, t).normalized();
    const Vector3& a = hull.vertices[static_cast<std::size_t>(hull.triangles[t][0])];
    double highest = -1.0;
    for (const Vector3& p : points) highest = std::max(highest, normal.dot(p - a));
    ASSERT_LT(highest, slack);
  }
}

TEST(ConvexHull, OfABoxOfGridPointsIsTheBox) {
  const std::vector<Vector3> points = make_box({1, 2, 3}, 6).vertices;
  const TriangleMesh hull = convex_hull(points);
  expect_around(hull, points, 1e-8);
  EXPECT_NEAR(signed_volume(hull), 6.0, 1e-9);
}

TEST(ConvexHull, OfASphereIsItself) {
  const TriangleMesh ball = make_sphere(0.1, 4);
  const TriangleMesh hull = convex_hull(ball.vertices);
  EXPECT_EQ(hull.triangles.size(), ball.triangles.size());
  EXPECT_NEAR(signed_volume(hull), signed_volume(ball), 1e-15);
}

TEST(ConvexHull, HoldsRandomPointsOfEveryScale) {
  Random random(5);
  for (const double scale : {1e-6, 1.0, 1e6}) {
    for (int round = 0; round < 20; ++round) {
      std::vector<Vector3> points;
      for (int i = 0; i < 200; ++i) {
        Vector3 p;
        // Few different values make many coplanar points.
        for (double& x : p) x = scale * static_cast<double>(random.index(round < 10 ? 5 : 100000));
        points.push_back(p);
      }
      const TriangleMesh hull = convex_hull(points);
      expect_around(hull, points, 1e-6 * bounds(hull).diagonal());
    }
  }
}

TEST(ConvexHull, ClosesTheGeneratedObjects) {
  for (const std::string& name : generated_object_names()) {
    SCOPED_TRACE(name);
    const TriangleMesh mesh = generate_object(name, 3000);
    const TriangleMesh hull = convex_hull(mesh.vertices);
    expect_around(hull, mesh.vertices, 1e-8);
    EXPECT_GE(signed_volume(hull), signed_volume(mesh) * (1.0 - 1e-9));
  }
}

TEST(ConvexHull, OfFlatOrBadPointsIsEmpty) {
  EXPECT_TRUE(convex_hull({}).empty());
  EXPECT_TRUE(convex_hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0.3, 0.2, 1e-9}}).empty());
  EXPECT_TRUE(convex_hull(std::vector<Vector3>(10, Vector3::Ones())).empty());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(convex_hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {nan, 0, 0}}).empty());
}

}  // namespace
}  // namespace prehend
