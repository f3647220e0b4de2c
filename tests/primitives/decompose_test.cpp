// Objects of several pieces, real scans, junk, and the promises of the contract.
#include "primitives/decompose.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <numeric>

#include <gtest/gtest.h>

#include "primitives/surface_sample.h"
#include "sim/geometry/input_error.h"
#include "sim/geometry/mesh_file.h"
#include "sim/geometry/object_generator.h"
#include "tests/primitives/test_meshes.h"
#include "tests/shared_data.h"

namespace prehend {
namespace {

int count_of(const Decomposition& result, std::string_view name) {
  return static_cast<int>(std::count_if(
      result.primitives.begin(), result.primitives.end(),
      [&](const Primitive& primitive) { return shape_name(primitive.shape) == name; }));
}

// The fraction of the area that is explained, on points of its own.
double explained(const TriangleMesh& mesh, const std::vector<Primitive>& primitives,
                 double tolerance) {
  constexpr int kPoints = 4000;
  const double reach = tolerance * bounds(mesh).diagonal();
  int near = 0;
  for (const SurfacePoint& s : sample_surface(mesh, kPoints, 99)) {
    near += std::any_of(primitives.begin(), primitives.end(), [&](const Primitive& p) {
      return std::abs(signed_distance(p, s.p_O)) <= reach;
    });
  }
  return static_cast<double>(near) / kPoints;
}

void expect_sound(const Decomposition& result, const TriangleMesh& mesh,
                  const DecomposeOptions& options = {}) {
  ASSERT_FALSE(result.primitives.empty());
  ASSERT_EQ(result.primitives.size(), result.share.size());
  EXPECT_LE(result.primitives.size(), static_cast<std::size_t>(options.max_primitives));
  EXPECT_TRUE(std::is_sorted(result.share.rbegin(), result.share.rend()));
  EXPECT_NEAR(std::accumulate(result.share.begin(), result.share.end(), 0.0), result.explained,
              1e-9);
  EXPECT_LE(result.explained, 1.0 + 1e-9);
  const double diagonal = bounds(mesh).diagonal();
  for (const Primitive& primitive : result.primitives) {
    EXPECT_TRUE(primitive.X_OP.matrix().allFinite());
    EXPECT_TRUE(primitive.X_OP.linear().isUnitary(1e-9));
    EXPECT_GT(primitive.X_OP.linear().determinant(), 0.0);
    EXPECT_GT(surface_area(primitive.shape), 0.0);
    EXPECT_LT(surface_area(primitive.shape), 100.0 * diagonal * diagonal);
  }
}

TEST(Decompose, ADumbbellIsTwoSpheresAndABar) {
  TriangleMesh mesh = make_cylinder(0.1, 1.6, 48, 20);
  for (const double z : {-1.0, 1.0}) {
    append(mesh, transformed(make_sphere(0.4, 4), translation({0.0, 0.0, z})));
  }
  const Decomposition result = decompose(mesh, {.tolerance = 0.02});
  expect_sound(result, mesh);
  EXPECT_EQ(result.primitives.size(), 3U);
  EXPECT_EQ(count_of(result, "sphere"), 2);
  EXPECT_EQ(count_of(result, "cylinder"), 1);
}

TEST(Decompose, AHammerIsABoxAndAHandle) {
  TriangleMesh mesh = make_cylinder(0.05, 1.0, 48, 10);
  append(mesh, transformed(make_box({0.15, 0.5, 0.15}, 6), translation({0.0, 0.0, 0.55})));
  const Decomposition result = decompose(mesh);
  expect_sound(result, mesh);
  EXPECT_EQ(result.primitives.size(), 2U);
  EXPECT_GT(result.explained, 0.97);
}

TEST(Decompose, TwoHalvesOfOneBoxAreOneBox) {
  TriangleMesh mesh = make_box({1.0, 1.0, 1.0}, 5);
  append(mesh, transformed(make_box({1.0, 1.0, 1.0}, 5), translation({1.0, 0.0, 0.0})));
  // The common wall inside is a ninth of the area, and no primitive's surface.
  const Decomposition result = decompose(mesh, {.coverage = 0.8});
  expect_sound(result, mesh);
  EXPECT_LE(result.primitives.size(), 2U);
  EXPECT_EQ(count_of(result, "box"), static_cast<int>(result.primitives.size()));
}

TEST(Decompose, GeneratedObjectsAreFewPieces) {
  for (const std::string& name : generated_object_names()) {
    SCOPED_TRACE(name);
    const TriangleMesh mesh = generate_object(name);
    const Decomposition result = decompose(mesh);
    expect_sound(result, mesh);
    EXPECT_LE(result.primitives.size(), 5U);
    EXPECT_GE(explained(mesh, result.primitives, 0.05), 0.95);
  }
}

TEST(Decompose, SameArgumentsSameBytes) {
  const TriangleMesh mesh = generate_object("mug");
  const Decomposition a = decompose(mesh);
  const Decomposition b = decompose(mesh);
  ASSERT_EQ(a.primitives.size(), b.primitives.size());
  for (std::size_t i = 0; i < a.primitives.size(); ++i) {
    EXPECT_EQ(a.primitives[i].X_OP.matrix(), b.primitives[i].X_OP.matrix());
    EXPECT_EQ(shape_name(a.primitives[i].shape), shape_name(b.primitives[i].shape));
    EXPECT_EQ(surface_area(a.primitives[i].shape), surface_area(b.primitives[i].shape));
    EXPECT_EQ(a.share[i], b.share[i]);
  }
}

TEST(Decompose, NeverMoreThanAskedFor) {
  test::Draw draw(4);
  const TriangleMesh soup = test::triangle_soup(200, draw);
  for (const int most : {1, 2, 5}) {
    const DecomposeOptions options{.tolerance = 0.01, .max_primitives = most};
    expect_sound(decompose(soup, options), soup, options);
  }
}

TEST(Decompose, AFinerToleranceIsHeldWhenPiecesAllow) {
  TriangleMesh mesh = make_box({0.2, 0.2, 1.0}, 8);
  append(mesh, transformed(make_box({0.2, 0.8, 0.2}, 8), translation({0.0, 0.5, 0.4})));
  for (const double tolerance : {0.05, 0.02}) {
    const Decomposition result = decompose(mesh, {.tolerance = tolerance});
    EXPECT_GE(explained(mesh, result.primitives, tolerance), 0.95) << tolerance;
  }
}

TEST(Decompose, JunkOfAnyScaleGivesSoundPieces) {
  test::Draw draw(5);
  TriangleMesh plate = make_box({1.0, 1.0, 1.0}, 10);
  for (Vector3& p : plate.vertices) p.z() = 0.0;
  TriangleMesh one;
  one.vertices = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};
  one.triangles = {{0, 1, 2}};
  TriangleMesh needle = one;
  needle.vertices[2] = {0.5, 1e-9, 0.0};
  TriangleMesh unused = make_sphere(1.0, 2);
  unused.vertices.emplace_back(1e6, 0.0, 0.0);
  for (const TriangleMesh& mesh : {plate, one, needle, test::triangle_soup(100, draw),
                                   test::without_triangles_above(make_sphere(1.0, 4), 0.3)}) {
    for (const double scale : {1e-3, 1.0, 10.0}) {
      const TriangleMesh at_scale = test::scaled(mesh, scale);
      expect_sound(decompose(at_scale), at_scale);
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
  EXPECT_THROW(decompose(box, {.max_primitives = 0}), InputError);
  TriangleMesh line = box;
  for (Vector3& p : line.vertices) p = {p.x(), 0.0, 0.0};
  EXPECT_THROW(decompose(line), InputError);
  TriangleMesh bad = box;
  bad.vertices[3].y() = nan;
  EXPECT_THROW(decompose(bad), InputError);
  bad = box;
  bad.triangles[0][1] = 1000;
  try {
    decompose(bad);
    FAIL() << "an index out of range was accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("1000"), std::string::npos) << error.what();
  }
}

std::vector<std::filesystem::path> meshes_in(const std::string& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(test::shared(folder))) {
    const auto kind = entry.path().extension();
    if (kind == ".obj" || kind == ".stl" || kind == ".ply" || kind == ".off") {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

TEST(DecomposeRealMeshes, AtMostTwelvePiecesExplainNinetyPercent) {
  for (const std::string folder : {"data/ycb", "data/household"}) {
    PREHEND_NEEDS_SHARED(folder);
    for (const auto& file : meshes_in(folder)) {
      SCOPED_TRACE(file.filename().string());
      const TriangleMesh mesh = load_mesh(file).mesh;
      const Decomposition result = decompose(mesh);
      expect_sound(result, mesh);
      EXPECT_LE(result.primitives.size(), 6U);  // of the twelve allowed
      EXPECT_GE(explained(mesh, result.primitives, 0.05), 0.9);
      EXPECT_NEAR(explained(mesh, result.primitives, 0.05), result.explained, 0.02);
    }
  }
}

TEST(DecomposeRealMeshes, SimpleObjectsAreOnePiece) {
  PREHEND_NEEDS_SHARED("data/ycb");
  const std::vector<std::pair<std::string, std::string>> known = {{"cracker_box", "box"},
                                                                  {"tomato_soup_can", "cylinder"},
                                                                  {"tennis_ball", "sphere"},
                                                                  {"large_marker", "cylinder"}};
  for (const auto& [name, shape] : known) {
    const Decomposition result =
        decompose(load_mesh(test::shared("data/ycb/" + name + ".obj")).mesh);
    EXPECT_EQ(result.primitives.size(), 1U) << name;
    EXPECT_EQ(shape_name(result.primitives.front().shape), shape) << name;
  }
}

// Published with the object set: 66 mm across, 101 mm high, of which the lids lie some 3 mm inside
// of each rim; a cap goes to the lid.
TEST(DecomposeRealMeshes, ACansDimensionsAreItsOwn) {
  PREHEND_NEEDS_SHARED("data/ycb/tomato_soup_can.obj");
  const Decomposition result =
      decompose(load_mesh(test::shared("data/ycb/tomato_soup_can.obj")).mesh);
  const auto& can = std::get<Cylinder>(result.primitives.front().shape);
  EXPECT_NEAR(can.radius, 0.033, 0.0015);
  EXPECT_GT(can.height, 0.092);
  EXPECT_LT(can.height, 0.103);
}

TEST(DecomposeRealMeshes, NastyMeshesGiveSoundPieces) {
  PREHEND_NEEDS_SHARED("data/nasty");
  for (const std::string folder : {"data/nasty", "data/nasty/converted_obj"}) {
    PREHEND_NEEDS_SHARED(folder);
    for (const auto& file : meshes_in(folder)) {
      SCOPED_TRACE(file.filename().string());
      const TriangleMesh mesh = load_mesh(file).mesh;
      expect_sound(decompose(mesh), mesh);
    }
  }
}

}  // namespace
}  // namespace prehend
