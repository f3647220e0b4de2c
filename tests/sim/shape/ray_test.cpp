// The first triangle on a ray, compared with the distances of all triangles and with closed forms.
#include "sim/shape/ray.h"

#include <gtest/gtest.h>

#include "sim/base/index.h"
#include "sim/base/random.h"
#include "sim/shape/basic_shapes.h"
#include "sim/shape/proximity.h"

namespace prehend {
namespace {

// The plane of the triangle, cut by the ray; inside where all three corners' areas have one sign.
double way_to(const TriangleMesh& mesh, std::size_t t, const Vector3& from,
              const Vector3& direction) {
  const Vector3& a = mesh.vertices[index(mesh.triangles[t][0])];
  const Vector3& b = mesh.vertices[index(mesh.triangles[t][1])];
  const Vector3& c = mesh.vertices[index(mesh.triangles[t][2])];
  const Vector3 normal = (b - a).cross(c - a);
  const double way = normal.dot(a - from) / normal.dot(direction);
  const Vector3 p = from + way * direction;
  const double u = normal.dot((b - a).cross(p - a));
  const double v = normal.dot((c - b).cross(p - b));
  const double w = normal.dot((a - c).cross(p - c));
  const bool inside = u >= 0.0 && v >= 0.0 && w >= 0.0;
  return way >= 0.0 && inside ? way : std::numeric_limits<double>::infinity();
}

TEST(FirstHit, IsTheNearestOfAllTriangles) {
  Random random(31);
  for (const TriangleMesh& mesh :
       {make_sphere(0.05, 3), make_box({0.1, 0.2, 0.3}, 5), make_cylinder(0.03, 0.2, 60, 10)}) {
    const ProximityMesh tree(mesh);
    for (int i = 0; i < 300; ++i) {
      const Vector3 from = random.vector(0.0, 0.2);
      const Vector3 direction = random.direction();
      double nearest = std::numeric_limits<double>::infinity();
      for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        nearest = std::min(nearest, way_to(mesh, t, from, direction));
      }
      const RayHit hit = first_hit(tree, from, direction);
      if (std::isinf(nearest)) {
        EXPECT_EQ(hit.triangle, -1);
        EXPECT_TRUE(std::isinf(hit.distance));
      } else {
        EXPECT_NEAR(hit.distance, nearest, 1e-12);
        EXPECT_NEAR(way_to(mesh, index(hit.triangle), from, direction), nearest, 1e-9);
      }
    }
  }
}

TEST(FirstHit, AlongAnAxisOfTheFrame) {
  const ProximityMesh box(make_box({0.2, 0.4, 0.6}, 3));
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3 from(0.013, 0.017, 0.019);
    const Vector3 direction = Vector3::Unit(axis);
    EXPECT_NEAR(first_hit(box, from, direction).distance, 0.1 * (axis + 1) - from[axis], 1e-12);
    EXPECT_NEAR(first_hit(box, from, -direction).distance, 0.1 * (axis + 1) + from[axis], 1e-12);
  }
}

// Nodes with fewer children than lanes have lanes far away on the diagonal, which no ray may meet.
TEST(FirstHit, AlongTheDiagonalOfTheFrameIsOfTriangles) {
  const ProximityMesh box(make_box({0.2, 0.2, 0.2}));
  const Vector3 diagonal = Vector3::Ones().normalized();
  EXPECT_EQ(first_hit(box, {1.0, 1.0, 1.0}, diagonal).triangle, -1);
  EXPECT_GE(first_hit(box, {-1.0, -1.0, -1.0}, diagonal).triangle, 0);
  EXPECT_EQ(first_hit(box, {-1.0, -1.0, -1.0}, -diagonal).triangle, -1);
}

TEST(FirstHit, BeyondTheCapIsNone) {
  const ProximityMesh box(make_box({0.2, 0.2, 0.2}));
  EXPECT_EQ(first_hit(box, {0.01, 0.02, 0.0}, Vector3::UnitX(), 0.089).triangle, -1);
  EXPECT_GE(first_hit(box, {0.01, 0.02, 0.0}, Vector3::UnitX(), 0.091).triangle, 0);
}

}  // namespace
}  // namespace prehend
