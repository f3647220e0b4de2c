// Objects of several pieces, junk, and the promises of the contract.
#include "primitives/decompose.h"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "sim/base/input_error.h"
#include "sim/base/random.h"
#include "sim/shape/object_generator.h"
#include "tests/primitives/expect_sound.h"
#include "tests/primitives/test_meshes.h"
#include "tests/support/refusal_of.h"

namespace prehend {
namespace {

int count_of(const Decomposition& result, std::string_view name) {
  return static_cast<int>(std::count_if(
      result.primitives.begin(), result.primitives.end(),
      [&](const Primitive& primitive) { return shape_name(primitive.shape) == name; }));
}

TEST(Decompose, ADumbbellIsTwoSpheresAndABar) {
  TriangleMesh mesh = make_cylinder(0.1, 1.6, 48, 20);
  for (const double z : {-1.0, 1.0}) {
    append(mesh, transformed(make_sphere(0.4, 4), translation({0.0, 0.0, z})));
  }
  const Decomposition result = decompose(mesh, {.tolerance = 0.02});
  test::expect_sound(result, mesh);
  EXPECT_EQ(result.primitives.size(), 3U);
  EXPECT_EQ(count_of(result, "sphere"), 2);
  EXPECT_EQ(count_of(result, "cylinder"), 1);
}

TEST(Decompose, AHammerIsABoxAndAHandle) {
  TriangleMesh mesh = make_cylinder(0.05, 1.0, 48, 10);
  append(mesh, transformed(make_box({0.15, 0.5, 0.15}, 6), translation({0.0, 0.0, 0.55})));
  const Decomposition result = decompose(mesh);
  test::expect_sound(result, mesh);
  EXPECT_EQ(result.primitives.size(), 2U);
  EXPECT_GT(result.explained, 0.97);
}

TEST(Decompose, TwoHalvesOfOneBoxAreOneBox) {
  TriangleMesh mesh = make_box({1.0, 1.0, 1.0}, 5);
  append(mesh, transformed(make_box({1.0, 1.0, 1.0}, 5), translation({1.0, 0.0, 0.0})));
  // The common wall inside is a ninth of the area, and no primitive's surface.
  const Decomposition result = decompose(mesh, {.coverage = 0.8});
  test::expect_sound(result, mesh);
  EXPECT_LE(result.primitives.size(), 2U);
  EXPECT_EQ(count_of(result, "box"), static_cast<int>(result.primitives.size()));
}

TEST(Decompose, GeneratedObjectsAreFewPieces) {
  for (const std::string& name : generated_object_names()) {
    SCOPED_TRACE(name);
    const TriangleMesh mesh = generate_object(name);
    const Decomposition result = decompose(mesh);
    test::expect_sound(result, mesh);
    EXPECT_LE(result.primitives.size(), 5U);
    EXPECT_GE(test::explained(mesh, result.primitives, 0.05), 0.95);
  }
}

void expect_same_bytes(const Decomposition& a, const Decomposition& b) {
  ASSERT_EQ(a.primitives.size(), b.primitives.size());
  for (std::size_t i = 0; i < a.primitives.size(); ++i) {
    EXPECT_EQ(a.primitives[i].X_OP.matrix(), b.primitives[i].X_OP.matrix());
    EXPECT_EQ(shape_name(a.primitives[i].shape), shape_name(b.primitives[i].shape));
    EXPECT_EQ(surface_area(a.primitives[i].shape), surface_area(b.primitives[i].shape));
    EXPECT_EQ(a.share[i], b.share[i]);
  }
  EXPECT_EQ(a.distances.median, b.distances.median);
}

TEST(Decompose, SameArgumentsSameBytes) {
  const TriangleMesh mesh = generate_object("mug");
  expect_same_bytes(decompose(mesh), decompose(mesh));
}

// Also where many splits are tried: of a soup, and with a fine tolerance.
TEST(Decompose, SameBytesOnAnyNumberOfThreads) {
  Random random(6);
  for (const TriangleMesh& mesh :
       {generate_object("mug"), generate_object("flask"), test::triangle_soup(100, random)}) {
    const DecomposeOptions options{.tolerance = 0.02};
    const Decomposition one = decompose(mesh, options, {.threads = 1});
    EXPECT_GT(one.primitives.size(), 1U);
    for (const int threads : {2, 5}) {
      SCOPED_TRACE(threads);
      expect_same_bytes(one, decompose(mesh, options, {.threads = threads}));
    }
  }
}

TEST(Decompose, NeverMoreThanAskedFor) {
  Random random(4);
  const TriangleMesh soup = test::triangle_soup(200, random);
  for (const int most : {1, 2, 5}) {
    const DecomposeOptions options{.tolerance = 0.01, .max_primitives = most};
    test::expect_sound(decompose(soup, options), soup, options);
  }
}

TEST(Decompose, AFinerToleranceIsHeldWhenPiecesAllow) {
  TriangleMesh mesh = make_box({0.2, 0.2, 1.0}, 8);
  append(mesh, transformed(make_box({0.2, 0.8, 0.2}, 8), translation({0.0, 0.5, 0.4})));
  for (const double tolerance : {0.05, 0.02}) {
    const Decomposition result = decompose(mesh, {.tolerance = tolerance});
    EXPECT_GE(test::explained(mesh, result.primitives, tolerance), 0.95) << tolerance;
  }
}

TEST(Decompose, JunkOfAnyScaleGivesSoundPieces) {
  Random random(5);
  TriangleMesh plate = make_box({1.0, 1.0, 1.0}, 10);
  for (Vector3& p : plate.vertices) p.z() = 0.0;
  TriangleMesh one;
  one.vertices = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};
  one.triangles = {{0, 1, 2}};
  TriangleMesh needle = one;
  needle.vertices[2] = {0.5, 1e-9, 0.0};
  TriangleMesh unused = make_sphere(1.0, 2);
  unused.vertices.emplace_back(1e6, 0.0, 0.0);
  for (const TriangleMesh& mesh : {plate, one, needle, test::triangle_soup(100, random),
                                   test::without_triangles_above(make_sphere(1.0, 4), 0.3)}) {
    for (const double scale : {1e-3, 1.0, 10.0}) {
      const TriangleMesh at_scale = test::scaled(mesh, scale);
      test::expect_sound(decompose(at_scale), at_scale);
    }
  }
  EXPECT_EQ(count_of(decompose(unused), "sphere"), 1);
}

TEST(Decompose, BadArgumentsAreNamed) {
  const TriangleMesh box = make_box({1.0, 1.0, 1.0});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(decompose({}), InputError);
  EXPECT_THROW(decompose(box, {.tolerance = 0.0}), InputError);
  EXPECT_THROW(decompose(box, {.tolerance = nan}), InputError);
  EXPECT_THROW(decompose(box, {.coverage = 1.5}), InputError);
  EXPECT_THROW(decompose(box, {.points = 99}), InputError);
  const InputError none = test::refusal_of([&] { decompose(box, {.max_primitives = 0}); });
  EXPECT_EQ(none.field(), "max_primitives");
  EXPECT_EQ(none.value(), "0");
  TriangleMesh line = box;
  for (Vector3& p : line.vertices) p = {p.x(), 0.0, 0.0};
  EXPECT_THROW(decompose(line), InputError);
  TriangleMesh bad = box;
  bad.vertices[3].y() = nan;
  EXPECT_THROW(decompose(bad), InputError);
  bad = box;
  bad.triangles[0][1] = 1000;
  const InputError error = test::refusal_of([&] { decompose(bad); });
  EXPECT_EQ(error.field(), "mesh.triangles[0]");
  EXPECT_EQ(error.value(), "1000");
}

// With a third of the points a cup is still a cylinder with a handle, of nearly the same size.
TEST(Decompose, FewerPointsFindTheSameParts) {
  const TriangleMesh mug = generate_object("mug", 2000);
  const Decomposition few = decompose(mug, {.points = 1000});
  const Decomposition many = decompose(mug);
  ASSERT_EQ(few.primitives.size(), 2U);
  ASSERT_EQ(many.primitives.size(), 2U);
  const auto& body = std::get<Cylinder>(few.primitives.front().shape);
  const auto& finer = std::get<Cylinder>(many.primitives.front().shape);
  EXPECT_NEAR(body.radius, finer.radius, 1e-3);
  EXPECT_NEAR(body.height, finer.height, 4e-3);
}

constexpr double kOtherKinds = std::numeric_limits<double>::infinity();

// How far the primitives of a moved and scaled object are from those of the object, moved and
// scaled [m]; infinite where they are of other kinds.
double change_of(const Decomposition& parts, const Decomposition& moved, const Pose& X_NO,
                 double factor) {
  if (parts.primitives.size() != moved.primitives.size()) return kOtherKinds;
  double most = 0.0;
  for (std::size_t k = 0; k < parts.primitives.size(); ++k) {
    const Primitive& a = parts.primitives[k];
    const Primitive& b = moved.primitives[k];
    if (a.shape.index() != b.shape.index()) return kOtherKinds;
    // Distances of the same places from both surfaces: of spheres and tubes the frame may turn.
    Random random(181);
    for (int i = 0; i < 50; ++i) {
      const Vector3 p_O = a.X_OP * random.vector(-0.1, 0.1);
      const Vector3 p_N = factor * (X_NO * p_O);
      most = std::max(most, std::abs(signed_distance(b, p_N) / factor - signed_distance(a, p_O)));
    }
  }
  return most;
}

TEST(Decompose, PrimitivesMoveAndScaleWithTheObject) {
  Random random(182);
  for (const char* kind : {"mug", "wine_glass", "bottle"}) {
    const TriangleMesh mesh = generate_object(kind, 2000);
    const Decomposition parts = decompose(mesh);
    for (const double factor : {1.0, 0.2, 7.0}) {
      const Pose X_NO = random.pose(0.5);
      const Decomposition moved = decompose(test::scaled(transformed(mesh, X_NO), factor));
      EXPECT_LT(change_of(parts, moved, X_NO, factor), 2e-4) << kind << " " << factor;
    }
    EXPECT_LT(change_of(parts, decompose(test::subdivided(mesh)), Pose::Identity(), 1.0), 5e-4)
        << kind;
  }
}

}  // namespace
}  // namespace prehend
