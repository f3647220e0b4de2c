#include "planner/show/report/packed_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "planner/show/picture/simplified_mesh.h"
#include "sim/shape/basic_shapes.h"
#include "sim/shape/object_generator.h"
#include "tests/planner/show/report/unpack.h"

namespace prehend {
namespace {

using test::unpacked;

std::string base64_of(const std::string& text) {
  return base64(std::vector<std::uint8_t>(text.begin(), text.end()));
}

TEST(Base64, TheVectorsOfRfc4648) {
  EXPECT_EQ(base64_of(""), "");
  EXPECT_EQ(base64_of("f"), "Zg==");
  EXPECT_EQ(base64_of("fo"), "Zm8=");
  EXPECT_EQ(base64_of("foo"), "Zm9v");
  EXPECT_EQ(base64_of("foob"), "Zm9vYg==");
  EXPECT_EQ(base64_of("fooba"), "Zm9vYmE=");
  EXPECT_EQ(base64_of("foobar"), "Zm9vYmFy");
}

TEST(Base64, EveryByteComesBack) {
  std::vector<std::uint8_t> bytes;
  for (int i = 0; i < 3 * 256; ++i) {
    bytes.push_back(static_cast<std::uint8_t>(i % 256));
    EXPECT_EQ(test::from_base64(base64(bytes)), bytes) << i;
  }
  EXPECT_EQ(base64({0xFB, 0xFF, 0xBF}), "+/+/");
}

TEST(PackedMesh, ComesBackInSinglePrecision) {
  TriangleMesh mesh = generate_object("mug", 500);
  mesh.vertices[0] = Vector3(-0.0, 1e-30, -123456.789);
  const TriangleMesh back = unpacked(packed_mesh(mesh));
  EXPECT_EQ(back.triangles, mesh.triangles);
  ASSERT_EQ(back.vertices.size(), mesh.vertices.size());
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    EXPECT_EQ(back.vertices[i], mesh.vertices[i].cast<float>().cast<double>()) << i;
  }
  const TriangleMesh nothing = unpacked(packed_mesh({}));
  EXPECT_TRUE(nothing.vertices.empty() && nothing.triangles.empty());
}

double area_of(const TriangleMesh& mesh) {
  double area = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    area += 0.5 * doubled_area_vector(mesh, t).norm();
  }
  return area;
}

TEST(Simplified, NotMoreThanTheLimitIsLeftAlone) {
  const TriangleMesh sphere = make_geodesic_sphere(0.05, 8);
  for (const std::size_t most : {sphere.triangles.size(), sphere.triangles.size() + 1}) {
    EXPECT_EQ(simplified(sphere, most).triangles, sphere.triangles);
    EXPECT_EQ(simplified(sphere, most).vertices, sphere.vertices);
  }
  EXPECT_TRUE(simplified({}, 10).triangles.empty());
}

// What is left of a sphere: corners on it, and triangles that stay near it, all around.
TEST(Simplified, ASphereStaysOne) {
  constexpr double kRadius = 0.05;
  const TriangleMesh sphere = make_geodesic_sphere(kRadius, 40);
  for (const std::size_t most : {30000U, 3000U, 300U}) {
    const TriangleMesh coarse = simplified(sphere, most);
    EXPECT_LE(coarse.triangles.size(), most);
    EXPECT_GT(coarse.triangles.size(), most / 3);
    const double apart =
        3.0 * kRadius * std::sqrt(4.0 * std::numbers::pi / static_cast<double>(most));
    for (const Vector3& v : coarse.vertices) EXPECT_NEAR(v.norm(), kRadius, 1e-9);
    for (const Triangle& t : coarse.triangles) {
      Vector3 middle = Vector3::Zero();
      for (const int v : t) middle += coarse.vertices[static_cast<std::size_t>(v)] / 3.0;
      EXPECT_GT(middle.norm(), kRadius - 0.5 * apart * apart / kRadius);
    }
    const double whole = 4.0 * std::numbers::pi * kRadius * kRadius;
    EXPECT_NEAR(area_of(coarse), whole, whole * apart / kRadius);
    for (const Vector3& v : sphere.vertices) {
      const bool near = std::any_of(coarse.vertices.begin(), coarse.vertices.end(),
                                    [&](const Vector3& c) { return (c - v).norm() < apart; });
      ASSERT_TRUE(near) << v.transpose();
    }
  }
}

// Much thinner than its length over the square root of the triangles.
TEST(Simplified, AThinRodDoesNotVanish) {
  const TriangleMesh rod = make_cylinder(0.5e-3, 1.0, 16, 2000);
  const TriangleMesh coarse = simplified(rod, 20000);
  EXPECT_LE(coarse.triangles.size(), 20000U);
  EXPECT_GT(area_of(coarse), 0.8 * area_of(rod));
}

TriangleMesh loose_triangles(int count, double size, double apart) {
  TriangleMesh mesh;
  for (int i = 0; i < count; ++i) {
    const Vector3 corner(apart * (i % 50), apart * (i / 50), 0.0);
    const int first = static_cast<int>(mesh.vertices.size());
    for (const Vector3& side : {Vector3::Zero().eval(), Vector3(size, 0, 0), Vector3(0, size, 0)}) {
      mesh.vertices.push_back(corner + side);
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

TEST(Simplified, OfLooseTrianglesSomeAreLeft) {
  const TriangleMesh coarse = simplified(loose_triangles(2500, 1e-3, 0.1), 500);
  EXPECT_LE(coarse.triangles.size(), 500U);
  ASSERT_GE(coarse.triangles.size(), 100U);
  EXPECT_NEAR(area_of(coarse), 0.5e-6 * static_cast<double>(coarse.triangles.size()), 1e-12);
  EXPECT_GT(bounds(coarse).diagonal(), 4.0);  // not of one corner only
}

// Meshes without area: all of them end, with something left and no more than was asked.
TEST(Simplified, FlatMeshesEnd) {
  const TriangleMesh box = make_box(Vector3(1, 1, 1), 10);
  const auto squeezed = [&](const Vector3& by) {
    TriangleMesh flat = box;
    for (Vector3& v : flat.vertices) v = Vector3(3, 4, 5) + v.cwiseProduct(by);
    return flat;
  };
  for (const Vector3& by :
       {Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(1, 1, 0), Vector3(1e-12, 1, 1e-12),
        Vector3(1e6, 1e6, 0), Vector3(1e-200, 0, 0), Vector3(1, 1e-200, 0)}) {
    for (const std::size_t most : {1U, 100U, 1000U}) {
      const TriangleMesh coarse = simplified(squeezed(by), most);
      EXPECT_LE(coarse.triangles.size(), most) << by.transpose();
      EXPECT_FALSE(coarse.triangles.empty()) << by.transpose() << ", " << most;
    }
  }
}

TEST(Simplified, OneFarPieceDoesNotTakeTheRest) {
  TriangleMesh mesh = make_sphere(0.05, 4);
  const TriangleMesh far = transformed(make_sphere(0.05, 0), translation(Vector3(1000, 0, 0)));
  const int first = static_cast<int>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), far.vertices.begin(), far.vertices.end());
  for (const Triangle& t : far.triangles) {
    mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  const TriangleMesh coarse = simplified(mesh, 1000);
  EXPECT_LE(coarse.triangles.size(), 1000U);
  EXPECT_GT(area_of(coarse), 0.9 * area_of(mesh));
}

}  // namespace
}  // namespace prehend
