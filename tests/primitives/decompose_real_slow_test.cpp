// Scans of household objects, and meshes that are broken in every way.
#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>

#include "primitives/decompose.h"
#include "sim/shape/files/mesh_file.h"
#include "tests/primitives/expect_sound.h"
#include "tests/support/shared_data.h"

namespace prehend {
namespace {

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
      test::expect_sound(result, mesh);
      EXPECT_LE(result.primitives.size(), 6U);  // of the twelve allowed
      EXPECT_GE(test::explained(mesh, result.primitives, 0.05), 0.9);
      EXPECT_NEAR(test::explained(mesh, result.primitives, 0.05), result.explained, 0.02);
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

TEST(DecomposeRealMeshes, ADrillsBatteryHandleAndBodyAreApart) {
  PREHEND_NEEDS_SHARED("data/ycb/power_drill.obj");
  const Decomposition result = decompose(load_mesh(test::shared("data/ycb/power_drill.obj")).mesh);
  EXPECT_GE(result.primitives.size(), 3U);
  EXPECT_EQ(shape_name(result.primitives.front().shape), "cylinder");
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
      test::expect_sound(decompose(mesh), mesh);
    }
  }
}

}  // namespace
}  // namespace prehend
