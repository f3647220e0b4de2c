#include "sim/shape/winding_number.h"

#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "sim/base/index.h"
#include "sim/base/random.h"
#include "sim/shape/object_generator.h"

namespace prehend {
namespace {

// The definition: the sum over all triangles of the solid angle, here from the angles at the three
// corners of the spherical triangle (Girard), unlike in the code under test.
double angle_at(const Vector3& corner, const Vector3& p, const Vector3& q) {
  const Vector3 a = corner.cross(p);
  const Vector3 b = corner.cross(q);
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

double winding_by_angles(const TriangleMesh& mesh, const Vector3& eye) {
  double sum = 0.0;
  for (const Triangle& t : mesh.triangles) {
    const Vector3 a = (mesh.vertices[index(t[0])] - eye).normalized();
    const Vector3 b = (mesh.vertices[index(t[1])] - eye).normalized();
    const Vector3 c = (mesh.vertices[index(t[2])] - eye).normalized();
    const double excess =
        angle_at(a, b, c) + angle_at(b, c, a) + angle_at(c, a, b) - std::numbers::pi;
    sum += a.dot(b.cross(c)) < 0.0 ? -excess : excess;
  }
  return sum / (4.0 * std::numbers::pi);
}

void expect_the_sum_over_all_triangles(const TriangleMesh& mesh, const std::string& name) {
  const std::vector<BoxNode> tree = build_box_tree(mesh);
  const BoundaryTree boundaries = build_boundary_tree(mesh, tree);
  const Bounds box = bounds(mesh);
  Random random(7);
  for (int i = 0; i < 200; ++i) {
    const Vector3 p = box.center() + random.in_box(0.6 * box.diagonal());
    ASSERT_NEAR(winding_number(mesh, tree, boundaries, p), winding_by_angles(mesh, p), 1e-6)
        << name << " " << p.transpose();
  }
}

TEST(WindingNumber, IsTheSumOverAllTriangles) {
  for (const char* name : {"mug", "bowl", "bottle"}) {
    expect_the_sum_over_all_triangles(generate_object(name, 3000), name);
  }
}

// A boundary that is left, unlike in a closed mesh; and vertices that no triangles share, so that
// nothing cancels.
TEST(WindingNumber, IsTheSumAlsoForOpenAndUnconnectedTriangles) {
  TriangleMesh open = generate_object("mug", 3000);
  open.triangles.resize(open.triangles.size() * 2 / 3);
  expect_the_sum_over_all_triangles(open, "open");
  TriangleMesh soup;
  for (const Triangle& t : open.triangles) {
    const int first = static_cast<int>(soup.vertices.size());
    for (int v : t) soup.vertices.push_back(open.vertices[index(v)]);
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  expect_the_sum_over_all_triangles(soup, "soup");
}

// Twice the same triangles traverse their boundary twice.
TEST(WindingNumber, CountsTrianglesThatAreThereTwice) {
  TriangleMesh mesh = generate_object("bottle", 2000);
  mesh.triangles.resize(mesh.triangles.size() / 2);
  const std::vector<Triangle> half = mesh.triangles;
  mesh.triangles.insert(mesh.triangles.end(), half.begin(), half.end());
  expect_the_sum_over_all_triangles(mesh, "doubled");
}

// The parts' boundaries are what a query goes through. For a closed surface they grow as the square
// root of the triangles in a part, so that all together stay in proportion to the mesh.
TEST(WindingNumber, StoresFewEdges) {
  const TriangleMesh mesh = generate_object("bottle", 20000);
  const std::vector<BoxNode> tree = build_box_tree(mesh);
  const BoundaryTree boundaries = build_boundary_tree(mesh, tree);
  EXPECT_EQ(boundaries.nodes.front().count, 0);
  EXPECT_LT(boundaries.edges.size(), 3 * mesh.triangles.size());
}

TEST(WindingNumber, OfNothingIsZero) {
  EXPECT_EQ(winding_number({}, {}, build_boundary_tree({}, {}), Vector3::Zero()), 0.0);
}

}  // namespace
}  // namespace prehend
