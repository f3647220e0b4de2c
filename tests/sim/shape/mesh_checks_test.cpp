#include "sim/shape/mesh_checks.h"

#include <limits>

#include <gtest/gtest.h>

#include "sim/base/input_error.h"
#include "tests/support/test_meshes.h"

namespace prehend {
namespace {

TEST(MeshChecks, OfAClosedBoxFindsNothing) {
  const MeshChecks checks = check_mesh(make_box({1, 2, 3}));
  EXPECT_EQ(checks.vertices, 8);
  EXPECT_EQ(checks.triangles, 12);
  EXPECT_EQ(checks.components, 1);
  EXPECT_TRUE(checks.closed());
  EXPECT_TRUE(checks.solid());
  EXPECT_FALSE(checks.inward);
}

TEST(MeshChecks, CountsTheBorderOfAHole) {
  TriangleMesh box = make_box({1, 2, 3});
  box.triangles.pop_back();
  EXPECT_EQ(check_mesh(box).boundary_edges, 3);
  EXPECT_FALSE(check_mesh(box).closed());
}

TEST(MeshChecks, CountsTheSidesOfATurnedTriangle) {
  TriangleMesh box = make_box({1, 2, 3});
  std::swap(box.triangles[4][0], box.triangles[4][1]);
  const MeshChecks checks = check_mesh(box);
  EXPECT_EQ(checks.misoriented_edges, 3);
  EXPECT_TRUE(checks.closed());
  EXPECT_FALSE(checks.solid());
}

TEST(MeshChecks, CountsAnEdgeThatTwoBoxesShare) {
  // Two boxes that touch along one edge have four triangles there.
  TriangleMesh boxes = make_box({1, 1, 1});
  append(boxes, test::moved(make_box({1, 1, 1}), {1, 1, 0}));
  for (Triangle& t : boxes.triangles) {
    for (int& v : t) {
      for (int first = 0; first < v; ++first) {
        const Vector3& p = boxes.vertices[static_cast<std::size_t>(first)];
        if (boxes.vertices[static_cast<std::size_t>(v)].isApprox(p)) v = first;
      }
    }
  }
  const MeshChecks checks = check_mesh(boxes);
  EXPECT_EQ(checks.nonmanifold_edges, 1);
  EXPECT_EQ(checks.components, 1);
  EXPECT_FALSE(checks.closed());
}

TEST(MeshChecks, KnowsAnInsideOutBox) {
  const MeshChecks checks = check_mesh(test::turned_over(make_box({1, 2, 3})));
  EXPECT_TRUE(checks.solid());
  EXPECT_TRUE(checks.inward);
}

TEST(MeshChecks, CountsComponentsDegenerateTrianglesAndBadVertices) {
  TriangleMesh mesh = make_box({1, 1, 1});
  append(mesh, test::moved(make_box({1, 1, 1}), {5, 0, 0}));
  mesh.triangles.push_back({0, 0, 1});
  mesh.vertices.push_back({std::numeric_limits<double>::quiet_NaN(), 0, 0});
  const MeshChecks checks = check_mesh(mesh);
  EXPECT_EQ(checks.components, 2);
  EXPECT_EQ(checks.degenerate_triangles, 1);
  EXPECT_EQ(checks.nonfinite_vertices, 1);
  EXPECT_EQ(checks.boundary_edges, 0);
  EXPECT_FALSE(checks.solid());
}

TEST(MeshChecks, OfNothingIsNotClosed) {
  EXPECT_FALSE(check_mesh({}).closed());
  EXPECT_EQ(check_mesh({}).components, 0);
}

TEST(MeshChecks, RefusesIndicesOfNoVertex) {
  EXPECT_THROW(check_mesh({{{0, 0, 0}}, {{0, 0, 1}}}), InputError);
  EXPECT_THROW(check_mesh({{{0, 0, 0}}, {{0, 0, -1}}}), InputError);
}

TEST(SignedVolume, ChangesSignWithTheWindingAndNotWithThePlace) {
  const TriangleMesh box = make_box({0.1, 0.2, 0.3});
  EXPECT_NEAR(signed_volume(test::turned_over(box)), -0.006, 1e-15);
  EXPECT_NEAR(signed_volume(test::moved(box, {1e4, -1e4, 1e4})), 0.006, 1e-9);
  EXPECT_EQ(signed_volume({}), 0.0);
}

}  // namespace
}  // namespace prehend
