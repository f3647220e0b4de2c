#include "planner/show/picture/vertex_arrays.h"

#include <cmath>
#include <limits>
#include <set>

#include <gtest/gtest.h>

#include "sim/base/input_error.h"
#include "sim/shape/basic_shapes.h"

namespace prehend {
namespace {

constexpr double kCrease = 0.7;  // radians

Vector3 vector(const std::array<float, 3>& v) {
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

// A rounding to single precision changes a unit vector's length by less.
constexpr double kRounding = 2e-7;

void expect_valid(const VertexArrays& arrays) {
  ASSERT_EQ(arrays.positions.size(), arrays.normals.size());
  std::vector<bool> used(arrays.positions.size(), false);
  for (const auto& triangle : arrays.triangles) {
    for (const std::uint32_t v : triangle) {
      ASSERT_LT(v, used.size());
      used[v] = true;
    }
  }
  std::set<std::array<std::array<float, 3>, 2>> known;
  for (std::size_t v = 0; v < used.size(); ++v) {
    EXPECT_TRUE(used[v]) << v;
    EXPECT_TRUE(known.insert({arrays.positions[v], arrays.normals[v]}).second) << v;
    EXPECT_NEAR(vector(arrays.normals[v]).norm(), 1.0, kRounding) << v;
  }
}

TEST(VertexArraysTest, ARoundSurfaceIsNotSplit) {
  const TriangleMesh mesh = make_sphere(0.3, 3);
  const VertexArrays arrays = vertex_arrays(mesh, kCrease);
  expect_valid(arrays);
  EXPECT_EQ(arrays.positions.size(), mesh.vertices.size());
  ASSERT_EQ(arrays.triangles.size(), mesh.triangles.size());
  for (std::size_t v = 0; v < arrays.positions.size(); ++v) {
    // The mean of the faces around a vertex leans less than a face does.
    EXPECT_GT(vector(arrays.normals[v]).dot(vector(arrays.positions[v]).normalized()), 0.999);
  }
}

TEST(VertexArraysTest, ACornerHasAVertexForEachOfItsFaces) {
  const TriangleMesh mesh = make_box(Vector3(0.1, 0.2, 0.3), 4);
  const VertexArrays arrays = vertex_arrays(mesh, kCrease);
  expect_valid(arrays);
  EXPECT_EQ(arrays.positions.size(), 6U * 5U * 5U);
  for (const auto& triangle : arrays.triangles) {
    const Vector3 a = vector(arrays.positions[triangle[0]]);
    const Vector3 across = (vector(arrays.positions[triangle[1]]) - a)
                               .cross(vector(arrays.positions[triangle[2]]) - a)
                               .normalized();
    for (const std::uint32_t v : triangle) {
      EXPECT_GT(across.dot(vector(arrays.normals[v])), 1.0 - 1e-5);
    }
  }
}

TEST(VertexArraysTest, TrianglesKeepTheirOrderAndCorners) {
  const TriangleMesh mesh = make_cylinder(0.04, 0.1, 24, 3);
  const VertexArrays arrays = vertex_arrays(mesh, kCrease);
  expect_valid(arrays);
  ASSERT_EQ(arrays.triangles.size(), mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto v = static_cast<std::size_t>(mesh.triangles[t][k]);
      EXPECT_EQ(vector(arrays.positions[arrays.triangles[t][k]]),
                mesh.vertices[v].cast<float>().cast<double>());
    }
  }
}

TEST(VertexArraysTest, LooseTrianglesAreOneSurface) {
  const TriangleMesh round = make_sphere(0.3, 2);
  TriangleMesh loose;
  for (const Triangle& triangle : round.triangles) {
    const int next = static_cast<int>(loose.vertices.size());
    for (const int v : triangle) {
      loose.vertices.push_back(round.vertices[static_cast<std::size_t>(v)]);
    }
    loose.triangles.push_back({next, next + 1, next + 2});
  }
  EXPECT_EQ(vertex_arrays(loose, kCrease).positions.size(), round.vertices.size());
}

TEST(VertexArraysTest, WhatHasNoAreaAndWhatIsNotUsedIsLeftOut) {
  TriangleMesh mesh = make_box(Vector3(1, 1, 1));
  const VertexArrays box = vertex_arrays(mesh, kCrease);
  mesh.vertices.emplace_back(100, 100, 100);
  mesh.triangles.push_back({0, 0, 1});
  mesh.triangles.push_back({8, 8, 8});
  const VertexArrays same = vertex_arrays(mesh, kCrease);
  EXPECT_EQ(same.positions, box.positions);
  EXPECT_EQ(same.normals, box.normals);
  EXPECT_EQ(same.triangles, box.triangles);
  EXPECT_TRUE(vertex_arrays({}, kCrease).positions.empty());
}

TEST(VertexArraysTest, WhatCannotBeWrittenIsRefused) {
  TriangleMesh mesh = make_box(Vector3(1, 1, 1));
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(), 1e39}) {
    TriangleMesh broken = mesh;
    broken.vertices[3].y() = bad;
    EXPECT_THROW(vertex_arrays(broken, kCrease), InputError) << bad;
  }
  for (const int bad : {-1, 8}) {
    TriangleMesh broken = mesh;
    broken.triangles[5][1] = bad;
    EXPECT_THROW(vertex_arrays(broken, kCrease), InputError) << bad;
  }
}

}  // namespace
}  // namespace prehend
