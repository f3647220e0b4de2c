#include <algorithm>

#include <gtest/gtest.h>

#include "sim/base/input_error.h"
#include "sim/base/random.h"
#include "sim/shape/basic_shapes.h"
#include "sim/shape/convex_pieces.h"
#include "sim/shape/mesh_checks.h"
#include "sim/shape/object_generator.h"
#include "tests/support/test_meshes.h"

namespace prehend {
namespace {

double volume_of(const ConvexPieces& found) {
  double volume = 0.0;
  for (const TriangleMesh& piece : found.pieces) volume += signed_volume(piece);
  return volume;
}

// How far p is above the highest face of a convex piece: <= 0 inside.
double height_over(const TriangleMesh& piece, const Vector3& p) {
  double most = -1e9;
  for (std::size_t t = 0; t < piece.triangles.size(); ++t) {
    const Vector3 normal = doubled_area_vector(piece, t).normalized();
    const auto corner = static_cast<std::size_t>(piece.triangles[t][0]);
    most = std::max(most, normal.dot(p - piece.vertices[corner]));
  }
  return most;
}

void expect_convex(const TriangleMesh& piece) {
  EXPECT_TRUE(check_mesh(piece).solid());
  for (const Vector3& p : piece.vertices) EXPECT_LE(height_over(piece, p), 1e-8);
}

// Points of the surface are in a piece: to rounding of the hulls.
void expect_covered(const ConvexPieces& found, const TriangleMesh& mesh) {
  Random random(7);
  for (int i = 0; i < 500; ++i) {
    const auto t = static_cast<std::size_t>(random.uniform(0.0, 0.999999) *
                                            static_cast<double>(mesh.triangles.size()));
    double u = random.uniform(0.0, 1.0);
    double v = random.uniform(0.0, 1.0);
    if (u + v > 1.0) {
      u = 1.0 - u;
      v = 1.0 - v;
    }
    const auto corner = [&](std::size_t k) {
      return mesh.vertices[static_cast<std::size_t>(mesh.triangles[t][k])];
    };
    const Vector3 p = corner(0) + u * (corner(1) - corner(0)) + v * (corner(2) - corner(0));
    double nearest = 1e9;
    for (const TriangleMesh& piece : found.pieces) {
      nearest = std::min(nearest, height_over(piece, p));
    }
    EXPECT_LE(nearest, 1e-8);
  }
}

TEST(ConvexPieces, AConvexMeshIsOnePiece) {
  for (const TriangleMesh& mesh :
       {make_box({0.1, 0.2, 0.05}), make_sphere(0.04), make_cylinder(0.03, 0.1)}) {
    const ConvexPieces found = convex_pieces(mesh);
    ASSERT_EQ(found.pieces.size(), 1U);
    EXPECT_EQ(found.overhang, 0.0);
    EXPECT_NEAR(signed_volume(found.pieces.front()), signed_volume(mesh), 1e-12);
  }
}

TEST(ConvexPieces, AnAngleIsTwoBoxes) {
  const TriangleMesh angle =
      make_prism({{0, 0}, {0.1, 0}, {0.1, 0.02}, {0.02, 0.02}, {0.02, 0.1}, {0, 0.1}}, 0.0, 0.03);
  const ConvexPieces found = convex_pieces(angle);
  EXPECT_EQ(found.pieces.size(), 2U);
  EXPECT_NEAR(volume_of(found), signed_volume(angle), 1e-12);
  expect_covered(found, angle);
}

TEST(ConvexPieces, PartsThatAreApartAreOnePieceEach) {
  TriangleMesh mesh = make_box({0.02, 0.02, 0.02});
  append(mesh, test::moved(make_sphere(0.01), {0.05, 0.0, 0.0}));
  append(mesh, test::moved(make_cylinder(0.01, 0.02), {0.0, 0.05, 0.0}));
  const ConvexPieces found = convex_pieces(mesh);
  EXPECT_EQ(found.pieces.size(), 3U);
  EXPECT_NEAR(volume_of(found), signed_volume(mesh), 1e-12);
}

// The mug stays hollow: its pieces have little more than its volume, and the middle of its inside
// is in none of them.
TEST(ConvexPieces, AMugStaysHollow) {
  const TriangleMesh mug = generate_object("mug", 3000);
  const ConvexPieces found = convex_pieces(mug, {.tolerance = 2e-3, .relative_tolerance = 1.0});
  EXPECT_EQ(found.overhang, 0.0);
  EXPECT_LE(found.pieces.size(), 60U);
  EXPECT_LT(volume_of(found), 1.5 * signed_volume(mug));
  for (const TriangleMesh& piece : found.pieces) EXPECT_GT(height_over(piece, {0, 0, 0.05}), 0.02);
  for (const TriangleMesh& piece : found.pieces) expect_convex(piece);
  expect_covered(found, mug);
}

// Of all generated objects, and the same ones each time.
TEST(ConvexPieces, OfGeneratedObjectsReachOutNoFartherThanTheTolerance) {
  const ConvexPiecesOptions coarse{.tolerance = 4e-3, .relative_tolerance = 1.0};
  for (const std::string& name : generated_object_names()) {
    const TriangleMesh mesh = generate_object(name, 800);
    const ConvexPieces found = convex_pieces(mesh, coarse);
    EXPECT_EQ(found.overhang, 0.0) << name;
    for (const TriangleMesh& piece : found.pieces) expect_convex(piece);
    expect_covered(found, mesh);
    const ConvexPieces again = convex_pieces(mesh, coarse);
    ASSERT_EQ(found.pieces.size(), again.pieces.size());
    for (std::size_t k = 0; k < found.pieces.size(); ++k) {
      EXPECT_EQ(found.pieces[k].vertices, again.pieces[k].vertices);
    }
  }
}

TEST(ConvexPieces, AreNoMoreThanAllowed) {
  const TriangleMesh mug = generate_object("mug", 1000);
  const ConvexPieces found = convex_pieces(mug, {.most = 5});
  EXPECT_LE(found.pieces.size(), 8U);  // the last cut may make several
  EXPECT_GT(found.overhang, 1e-3);
  expect_covered(found, mug);
}

TEST(ConvexPieces, AFlatMeshGetsAThickness) {
  TriangleMesh flat;
  flat.vertices = {{0, 0, 0}, {0.1, 0, 0}, {0.1, 0.1, 0}, {0, 0.1, 0}};
  flat.triangles = {{0, 1, 2}, {0, 2, 3}};
  const ConvexPieces found = convex_pieces(flat);
  ASSERT_EQ(found.pieces.size(), 1U);
  EXPECT_NEAR(signed_volume(found.pieces.front()), 0.1 * 0.1 * 2e-4, 1e-7);
}

TEST(ConvexPieces, RefuseWhatCannotBe) {
  EXPECT_THROW(convex_pieces({}), InputError);
  EXPECT_THROW(convex_pieces(make_box({1, 1, 1}), {.tolerance = 0.0}), InputError);
  EXPECT_THROW(convex_pieces(make_box({1, 1, 1}), {.most = 0}), InputError);
}

}  // namespace
}  // namespace prehend
