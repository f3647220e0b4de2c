#include "sim/shape/make_mesh.h"

#include <limits>

#include <gtest/gtest.h>

#include "sim/base/input_error.h"
#include "sim/shape/basic_shapes.h"
#include "sim/shape/mesh_checks.h"
#include "tests/support/refusal_of.h"

namespace prehend {
namespace {

std::string complaint(const std::vector<Vector3>& vertices,
                      const std::vector<Triangle>& triangles) {
  try {
    make_mesh(vertices, triangles);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

// Every triangle with corners of its own, as STL files have them, and facing inward.
TEST(MakeMesh, ASoupOfInwardTrianglesBecomesASolid) {
  const TriangleMesh box = make_box({0.02, 0.04, 0.06}, 2);
  std::vector<Vector3> vertices = {Vector3(9.0, 9.0, 9.0)};  // of no triangle
  std::vector<Triangle> triangles;
  for (const auto& [a, b, c] : box.triangles) {
    const int first = static_cast<int>(vertices.size());
    for (const int v : {c, b, a}) vertices.push_back(box.vertices[static_cast<std::size_t>(v)]);
    triangles.push_back({first, first + 1, first + 2});
  }
  triangles.push_back({0, 0, 1});  // no area
  const TriangleMesh made = make_mesh(vertices, triangles);
  EXPECT_EQ(made.vertices.size(), box.vertices.size());
  EXPECT_EQ(made.triangles.size(), box.triangles.size());
  EXPECT_TRUE(check_mesh(made).solid());
  EXPECT_NEAR(signed_volume(made), 0.02 * 0.04 * 0.06, 1e-15);
}

TEST(MakeMesh, AMeshThatIsSoundStaysAsItIs) {
  const TriangleMesh sphere = make_sphere(0.03, 2);
  const TriangleMesh made = make_mesh(sphere.vertices, sphere.triangles);
  EXPECT_EQ(made.vertices, sphere.vertices);
  EXPECT_EQ(made.triangles, sphere.triangles);
}

TEST(MakeMesh, WhatIsNoMeshIsRefused) {
  const std::vector<Vector3> corners = {Vector3::Zero(), Vector3::UnitX(), Vector3::UnitY()};
  EXPECT_NE(complaint(corners, {{0, 1, 2}, {0, 1, 3}}).find("triangles[1]"), std::string::npos);
  EXPECT_NE(complaint(corners, {{0, -1, 2}}).find("(-1)"), std::string::npos);
  const InputError fraction = test::refusal_of([&] { make_mesh(corners, {{0, 1, 2}}, 0.5); });
  EXPECT_EQ(fraction.field(), "weld_fraction");
  EXPECT_EQ(fraction.value(), "0.500000");
  EXPECT_NE(complaint(corners, {{0, 1, 1}}).find("area"), std::string::npos);
  EXPECT_NE(complaint(corners, {}).find("area"), std::string::npos);
  std::vector<Vector3> infinite = corners;
  infinite[2].x() = std::numeric_limits<double>::infinity();
  EXPECT_NE(complaint(infinite, {{0, 1, 2}}).find("vertices[2]"), std::string::npos);
}

}  // namespace
}  // namespace prehend
