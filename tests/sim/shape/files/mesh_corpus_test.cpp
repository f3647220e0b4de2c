// Real and broken files from outside the project, one line each: what must come of them.
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sim/base/input_error.h"
#include "sim/shape/files/mesh_file.h"
#include "sim/shape/mass_properties.h"
#include "sim/shape/mesh_checks.h"
#include "tests/support/shared_data.h"

namespace prehend {
namespace {

struct Expected {
  const char* file;
  int triangles = 0;       // 0: an error
  const char* error = "";  // a phrase of it
  MassSource source = MassSource::signed_volume;
};

constexpr MassSource kSolid = MassSource::signed_volume;
constexpr MassSource kHoles = MassSource::closed_holes;
constexpr MassSource kHull = MassSource::convex_hull;
constexpr MassSource kSurface = MassSource::surface;

const std::vector<Expected>& corpus() {
  static const std::vector<Expected> files{
      {"nasty/can_scan_open.wrl", 3707, "", kHull},
      {"nasty/cgal_ALSTOM_TEST4.off", 2033, "", kHull},
      {"nasty/cgal_blobby-shuffled.off", 4050, "", kSolid},
      {"nasty/cgal_double-torus-3-holes.off", 428, "", kHoles},
      {"nasty/cgal_elephant-with-holes.off", 4463, "", kHull},
      {"nasty/cgal_open_cube.off", 10, "", kHoles},
      {"nasty/cgal_tetra_intersected_by_triangle.off", 5, "", kHoles},
      {"nasty/converted_obj/can_scan_open.obj", 3707, "", kHull},
      {"nasty/converted_obj/gun_42_shells.obj", 1830, "", kHull},
      {"nasty/converted_obj/lego_plate_open_parts.obj", 4540, "", kHoles},
      {"nasty/converted_obj/vitalis_box_misoriented.obj", 12, "", kSolid},
      {"nasty/cycloidal_100_parts.ply", 43368, "", kSolid},
      {"nasty/drinking_glass_thin.stl", 160, "", kSolid},
      {"nasty/gun_42_shells.iv", 1830, "", kHull},
      {"nasty/lego_plate_open_parts.wrl", 4540, "", kHoles},
      {"nasty/manifold_self_intersectA.obj", 17160, "", kSolid},
      {"nasty/medium_clamp_262k.ply", 262144, "", kSolid},
      {"nasty/pitcher_scan_open_79k.stl", 79360, "", kHoles},
      {"nasty/triangle_soup.stl", 100, "", kHull},
      {"nasty/vitalis_box_misoriented.iv", 12, "", kSolid},
      {"nasty/wing_bad_ascii_stl.stl", 841, "", kHoles},
      {"parser/assimp_Wuson.ply", 3732, "", kHoles},
      {"parser/assimp_box_UTF16BE.obj", 0, "the text is UTF-16"},
      {"parser/assimp_invalid.off", 0, "line 6: a face of 0 corners"},
      {"parser/assimp_issue623.ply", 0, "a surface of element 'vertex'"},
      {"parser/assimp_malformed.obj", 0, "line 28: a face has the vertex '0'"},
      {"parser/assimp_number_formats.obj", 0, "line 11: a coordinate is not a number ('3.1+e2')"},
      {"parser/assimp_regr01.obj", 2699, "", kHoles},
      {"parser/assimp_sphereWithHole.stl", 285, "", kHoles},
      {"parser/assimp_triangle_with_empty_solid.stl", 1, "", kSurface},
      {"parser/oscad_empty2.stl", 0, "no triangles"},
      {"parser/oscad_issue1580-zero-area-triangle.stl", 13, "", kHoles},
      {"parser/oscad_toomanyvertices.stl", 12, "", kSolid},
      {"parser/tri_empty.stl", 0, "no triangles"},
      {"parser/tri_metadata.ply", 2, "", kSurface},
      {"parser/tri_negative_indices.obj", 12, "", kSolid},
      {"parser/tri_notenoughindices.obj", 1, "", kSurface},
      {"parser/tri_points_ascii.ply", 0, "no triangles"},
      {"parser/tri_polygonfaces.obj", 3, "", kHull},
      {"parser/tri_two_objects_mixed_case_names.stl", 24, "", kSolid},
      {"parser/tri_whitespace.off", 12, "", kSolid},
  };
  return files;
}

std::string test_name(const std::string& file) {
  std::string name;
  for (const char c : file) name += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  return name;
}

class NastyFile : public testing::TestWithParam<Expected> {};

TEST_P(NastyFile, GivesAMeshThatCanBeUsedOrOneLine) {
  PREHEND_NEEDS_SHARED("data");
  const std::filesystem::path file = test::shared(std::string("data/") + GetParam().file);
  try {
    TriangleMesh mesh = load_mesh(file).mesh;
    ASSERT_EQ(static_cast<int>(mesh.triangles.size()), GetParam().triangles);
    orient_outward(mesh);
    const MeshChecks checks = check_mesh(mesh);
    EXPECT_EQ(checks.nonfinite_vertices, 0);
    EXPECT_EQ(checks.degenerate_triangles, 0);
    EXPECT_EQ(checks.misoriented_edges, 0);
    const MassProperties mass = mass_properties(mesh);
    EXPECT_EQ(mass.source, GetParam().source);
    EXPECT_TRUE(mass.center_of_mass.allFinite());
    EXPECT_TRUE(mass.unit_inertia.allFinite());
    EXPECT_EQ(mass.volume > 0.0, mass.source != MassSource::surface);
  } catch (const InputError& error) {
    const std::string text = error.what();
    EXPECT_EQ(GetParam().triangles, 0) << text;
    EXPECT_TRUE(text.starts_with(file.string() + ": ")) << text;
    EXPECT_NE(text.find(GetParam().error), std::string::npos) << text;
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
  }
}

INSTANTIATE_TEST_SUITE_P(Corpus, NastyFile, testing::ValuesIn(corpus()),
                         [](const auto& file) { return test_name(file.param.file); });

TEST(NastyFiles, AreAllInTheCorpus) {
  PREHEND_NEEDS_SHARED("data");
  for (const char* folder : {"data/nasty", "data/parser"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(test::shared(folder))) {
      if (!entry.is_regular_file()) continue;
      const std::string name =
          std::filesystem::relative(entry.path(), test::shared("data")).generic_string();
      const bool listed = std::any_of(corpus().begin(), corpus().end(),
                                      [&](const Expected& line) { return line.file == name; });
      EXPECT_TRUE(listed) << name;
    }
  }
}

// Facts of the scanned and modelled objects as another program measured them.
TEST(ManifestFacts, HoldForTheObjectsThatCanBeRead) {
  PREHEND_NEEDS_SHARED("data/manifest.json");
  std::ifstream stream(test::shared("data/manifest.json"));
  const nlohmann::json manifest = nlohmann::json::parse(stream);
  int compared = 0;
  for (const nlohmann::json& object : manifest["objects"]) {
    const std::string name = object["file"];
    const std::string format = object["format"];
    if (!name.starts_with("ycb/") && !name.starts_with("household/")) continue;
    if (format != "obj" && format != "stl" && format != "ply" && format != "off") continue;
    SCOPED_TRACE(name);
    const LoadedMesh loaded =
        load_mesh(test::shared("data/" + name), {.metres_per_unit = object["scale_to_m"]});
    const MeshChecks checks = check_mesh(loaded.mesh);
    EXPECT_EQ(checks.triangles + loaded.degenerate_removed + loaded.duplicates_removed,
              object["triangles"].get<int>());
    EXPECT_EQ(checks.components, object["components"].get<int>());
    for (std::size_t k = 0; k < 3; ++k) {
      const double extent = object["bbox_extent_m"][k];
      EXPECT_NEAR(bounds(loaded.mesh).size()[static_cast<Eigen::Index>(k)], extent, 1e-5);
    }
    // Without their fins all scans are solids.
    EXPECT_TRUE(!name.starts_with("ycb/") || checks.solid());
    if (object["watertight"]) {
      EXPECT_TRUE(checks.solid());
      EXPECT_FALSE(checks.inward);
      const double volume = object["signed_volume_m3"];
      EXPECT_NEAR(signed_volume(loaded.mesh), volume, 1e-4 * volume);
    }
    ++compared;
  }
  EXPECT_EQ(compared, 18);
}

}  // namespace
}  // namespace prehend
