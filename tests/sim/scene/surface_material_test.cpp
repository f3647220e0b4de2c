// Parts of surfaces of other materials, and how scene files state them.
#include "sim/scene/surface_material.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/base/random.h"
#include "sim/scene/compiled_scene.h"
#include "sim/scene/object_friction.h"
#include "sim/scene/scene_file.h"
#include "sim/scene/scene_text.h"
#include "sim/shape/basic_shapes.h"
#include "sim/shape/mesh_checks.h"
#include "sim/shape/nearest_point.h"
#include "sim/shape/nearest_triangle.h"
#include "tests/support/refusal_of.h"

namespace prehend {
namespace {

namespace fs = std::filesystem;

// A tray along x: its floor and its four walls have names, and the top is missing.
void write_tray(const fs::path& file) {
  std::ofstream obj(file);
  const TriangleMesh box = make_box({0.1, 0.04, 0.06});
  for (const Vector3& v : box.vertices) {
    obj << "v " << v.x() << " " << v.y() << " " << v.z() << "\n";
  }
  for (const bool walls : {false, true}) {
    obj << (walls ? "usemtl steel\ng walls\n" : "usemtl rubber_coat\ng floor\n");
    for (std::size_t t = 0; t < box.triangles.size(); ++t) {
      const Vector3 normal = doubled_area_vector(box, t).normalized();
      if (normal.z() > 0.5 || (normal.z() < -0.5) == walls) continue;
      const Triangle& corners = box.triangles[t];
      obj << "f " << corners[0] + 1 << " " << corners[1] + 1 << " " << corners[2] + 1 << "\n";
    }
  }
}

fs::path tray_scene(const std::string& object_fields, const std::string& fields = "") {
  const fs::path folder = testing::TempDir();
  write_tray(folder / "tray.obj");
  const std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
  const fs::path file = folder / ("surface_" + name + ".json");
  std::ofstream(file) << R"({"object": {"mesh": "tray.obj", "material": "metal")" << object_fields
                      << R"(}, "hand": "parallel_jaw")" << fields << "}";
  return file;
}

std::string surface_refusal(const fs::path& file) {
  const std::string words = test::refusal_of([&] { (void)load_scene(file); }).what();
  const std::string name = file.string();
  return words.starts_with(name) ? words.substr(name.size() + 2) : words;
}

SurfaceRegion ball_around(const Vector3& p, double radius) {
  SurfaceRegion region;
  region.inside = {Sphere{radius}, translation(p)};
  return region;
}

SurfaceRegion beyond(const Vector3& point, const Vector3& normal) {
  SurfaceRegion region;
  region.beyond = BeyondPlane{point, normal};
  return region;
}

TEST(NearestTriangles, AreThoseOfAnySearch) {
  const ProximityMesh mesh(make_sphere(0.05, 3));
  Random random(5);
  std::vector<int> found;
  for (int i = 0; i < 300; ++i) {
    const Vector3 p = std::pow(10.0, random.uniform(-3.0, 1.0)) * random.direction();
    const double margin = random.uniform(1e-5, 5e-3);
    std::vector<double> distances;
    for (int t = 0; t < std::ssize(mesh.mesh().triangles); ++t) {
      distances.push_back((nearest_point_on(corners_of(mesh.mesh(), t), p) - p).norm());
    }
    const double least = *std::min_element(distances.begin(), distances.end());
    std::vector<int> expected;
    for (int t = 0; t < std::ssize(distances); ++t) {
      if (distances[static_cast<std::size_t>(t)] <= least + margin) expected.push_back(t);
    }
    nearest_triangles(mesh, p, margin, found);
    EXPECT_EQ(found, expected) << p.transpose();
  }
}

TEST(SurfaceMaterial, OwnFrictionReplacesThatOfTheTable) {
  const FrictionTable table;
  const SurfaceMaterial rubber{Material::rubber};
  const SurfaceMaterial glass{Material::glass};
  EXPECT_EQ(friction_between(table, rubber, glass), 1.0);
  SurfaceMaterial wet{Material::glass, "wet"};
  wet.friction[Material::rubber] = 0.3;
  EXPECT_EQ(friction_between(table, rubber, wet), 0.3);
  EXPECT_EQ(friction_between(table, wet, rubber), 0.3);
  EXPECT_EQ(friction_between(table, wet, glass), 0.2);
  SurfaceMaterial oily{Material::rubber, "oily"};
  oily.friction[Material::glass] = 0.1;
  EXPECT_EQ(friction_between(table, oily, wet), 0.1);
  oily.friction[Material::glass] = 0.5;
  EXPECT_EQ(friction_between(table, oily, wet), 0.3);
}

TEST(SurfaceMaterial, TheSofterOneGivesWay) {
  const CompliantDepths depths;
  const SurfaceMaterial rubber{Material::rubber};
  SurfaceMaterial foam{Material::plastic, "foam"};
  foam.compliant_depth = 0.004;
  EXPECT_EQ(depth_between(depths, rubber, {Material::metal}), 0.001);
  EXPECT_EQ(depth_between(depths, rubber, foam), 0.004);
  foam.compliant_depth = 0.0;
  EXPECT_EQ(depth_between(depths, {Material::glass}, foam), 0.0);
}

// A ball at a height over a face that is much larger than it: they meet where the radius and the
// margin reach the face.
TEST(SurfaceMaterial, ARegionHasSurfaceWhereItMeetsATriangle) {
  const TriangleMesh box = make_box({2.0, 2.0, 2.0});
  Random random(7);
  for (int i = 0; i < 500; ++i) {
    const Vector3 p(random.uniform(-0.8, 0.8), random.uniform(-0.8, 0.8),
                    1.0 + random.uniform(-0.1, 0.1));
    const double radius = random.uniform(0.001, 0.1);
    const double spare = radius + SurfaceRegions::kMargin - std::abs(p.z() - 1.0);
    if (std::abs(spare) < 1e-6) continue;
    EXPECT_EQ(has_surface_of(ball_around(p, radius), box), spare > 0.0 || radius > 1.0);
  }
  EXPECT_TRUE(has_surface_of(beyond({0.0, 0.0, 0.99}, Vector3::UnitZ()), box));
  EXPECT_FALSE(has_surface_of(beyond({0.0, 0.0, 1.01}, Vector3::UnitZ()), box));
}

TEST(SurfaceMaterials, TheLastRegionWithAPointCounts) {
  const ProximityMesh box(make_box({0.1, 0.1, 0.1}));
  const SurfaceMaterials materials(Material::wood,
                                   {{beyond(Vector3::Zero(), Vector3::UnitX()), {Material::metal}},
                                    {ball_around({0.05, 0.0, 0.05}, 0.02), {Material::rubber}}},
                                   box);
  EXPECT_FALSE(materials.uniform());
  EXPECT_EQ(materials.at({-0.02, 0.0, 0.05}).material, Material::wood);
  EXPECT_EQ(materials.at({0.02, 0.0, 0.05}).material, Material::metal);
  EXPECT_EQ(materials.at({0.04, 0.0, 0.05}).material, Material::rubber);
  EXPECT_EQ(materials.at({-1e-4, 0.0, 0.05}).material, Material::metal);  // within the margin
  EXPECT_TRUE(SurfaceMaterials(Material::wood, {}, box).uniform());
}

TEST(SurfaceMaterials, PartsOfTheFileOutliveItsRepair) {
  const Scene scene = load_scene(tray_scene(
      R"(, "surfaces": [{"part": "floor", "material": "rubber"}, {"part": "walls", "material": "wood"}])"));
  ASSERT_TRUE(check_mesh(scene.object.mesh).solid());  // it got a lid
  EXPECT_EQ(scene.object.surfaces[0].where.surface.triangles.size(), 2U);
  const CompiledScene compiled = compile(scene);
  const SurfaceMaterials& materials = compiled.object_surface;
  EXPECT_EQ(materials.at({0.01, 0.005, -0.03}).material, Material::rubber);
  EXPECT_EQ(materials.at({0.01, 0.02, 0.0}).material, Material::wood);
  EXPECT_EQ(materials.at({-0.05, 0.0, 0.0}).material, Material::wood);
  // What closes the hole is of what is around it.
  EXPECT_EQ(materials.at({0.01, 0.005, 0.03}).material, Material::wood);
  // A little off the surface, as contacts are.
  EXPECT_EQ(materials.at({0.01, 0.005, -0.0304}).material, Material::rubber);
  // On the edge between both, the later one.
  EXPECT_EQ(materials.at({0.01, 0.02, -0.03}).material, Material::wood);
}

TEST(SurfaceMaterials, AreReadAndWrittenAgain) {
  const fs::path file = tray_scene(
      R"(, "surfaces": [{"part": "floor", "material": "rubber"},
          {"beyond": {"point": [0.03, 0, 0], "normal": [1, 0, 0]}, "material": "wet"},
          {"inside": {"shape": "sphere", "radius": 0.025}, "material": "slick"}])",
      R"(, "materials": {"wet": {"like": "metal", "friction": {"rubber": 0.25}},
                         "slick": {"like": "plastic", "friction": 0.05, "compliant_depth": 0.002}},
         "link_surfaces": {"left_plate": [{"beyond": {"point": [0, 0, 0.04], "normal": [0, 0, 1]},
                                           "material": "metal"}]},
         "friction": [{"between": ["rubber", "metal"], "deviation": 0.5},
                      {"between": ["wood", "metal"], "static": 0.35, "deviation": 0.1}],
         "obstacles": [{"name": "wall", "geometry": [{"shape": "box", "size": [0.1, 0.1, 0.1]}],
                        "pose": {"position": [1, 0, 0]},
                        "surfaces": [{"inside": {"shape": "box", "size": [0.2, 0.2, 0.02]},
                                      "material": "wet"}]}])");
  const Scene first = load_scene(file);
  const fs::path again = fs::path(testing::TempDir()) / "surface_again.json";
  std::ofstream(again) << scene_text(first);
  for (const Scene& scene : {first, load_scene(again)}) {
    ASSERT_EQ(scene.object.surfaces.size(), 3U);
    EXPECT_EQ(scene.object.surfaces[0].of.material, Material::rubber);
    EXPECT_EQ(scene.object.surfaces[1].of.name, "wet");
    EXPECT_EQ(scene.object.surfaces[1].of.friction[Material::rubber], 0.25);
    EXPECT_EQ(scene.object.surfaces[1].of.friction[Material::metal], std::nullopt);
    EXPECT_EQ(scene.object.surfaces[1].where.beyond->point_O.x(), 0.03);
    EXPECT_EQ(scene.object.surfaces[2].of.friction[Material::glass], 0.05);
    EXPECT_EQ(scene.object.surfaces[2].of.compliant_depth, 0.002);
    ASSERT_EQ(scene.link_surfaces.size(), 1U);
    EXPECT_EQ(scene.link_surfaces[0].link, "left_plate");
    EXPECT_EQ(scene.obstacles[0].surfaces[0].of.name, "wet");
    EXPECT_EQ(scene.friction_deviations.between(Material::metal, Material::rubber), 0.5);
    EXPECT_EQ(scene.friction.between(Material::metal, Material::rubber), 1.0);
    EXPECT_EQ(scene.friction_deviations.between(Material::metal, Material::wood), 0.1);
    EXPECT_EQ(scene.friction.between(Material::metal, Material::wood), 0.35);
  }
  EXPECT_EQ(scene_text(load_scene(again)), scene_text(first));
}

TEST(SurfaceMaterials, OneFrictionOfTheObjectIsThatOfAllItsParts) {
  Scene scene = load_scene(tray_scene(
      R"(, "surfaces": [{"part": "floor", "material": "rubber"}])",
      R"(, "link_surfaces": {"left_plate": [{"beyond": {"point": [0, 0, 0], "normal": [0, 0, 1]},
                                             "material": "oily"}]},
         "materials": {"oily": {"like": "rubber", "friction": 0.1}})"));
  for (const double friction : {0.7, 0.45}) {
    set_object_friction(scene, friction);
    const CompiledScene compiled = compile(scene);
    for (const Vector3& p : {Vector3(0.0, 0.0, -0.03), Vector3(0.0, 0.02, 0.0)}) {
      for (const Material of_hand : kAll<Material>) {
        EXPECT_EQ(friction_between(scene.friction, compiled.object_surface.at(p), {of_hand}),
                  friction);
      }
      EXPECT_EQ(friction_between(scene.friction, compiled.object_surface.at(p),
                                 scene.link_surfaces[0].surfaces[0].of),
                friction);
    }
  }
  EXPECT_EQ(scene.object.surfaces[0].of.name, "rubber with friction 0.45");
}

TEST(SurfaceMaterials, ThoseOfLinksAreOfTheHandOfTheScene) {
  const fs::path file = tray_scene(
      "",
      R"(, "link_surfaces": {"left_plate": [{"beyond": {"point": [0, 0, 0.04], "normal": [0, 0, 1]},
                                                 "material": "metal"}]})");
  const CompiledScene own = compile(load_scene(file));
  for (const CompiledLink& link : own.links) {
    EXPECT_EQ(link.surface.uniform(), link.name != "left_plate");
  }
  const Scene other = load_scene(file, {.hand = "franka_hand"});
  EXPECT_TRUE(other.link_surfaces.empty());
  EXPECT_EQ(other.notes.back(), "link_surfaces are of another hand: not used");
}

TEST(SurfaceMaterials, MistakesNameTheField) {
  const auto refused = [](const std::string& surface, const std::string& fields = "") {
    return surface_refusal(tray_scene(", \"surfaces\": [{" + surface + "}]", fields));
  };
  EXPECT_EQ(refused(R"("part": "floor", "material": "ruber")"),
            "object.surfaces[0].material: unknown material; did you mean rubber? known are glass, "
            "metal, plastic, wood, rubber (\"ruber\")");
  EXPECT_EQ(refused(R"("part": "floor", "material": "weet")",
                    R"(, "materials": {"wet": {"like": "glass"}})"),
            "object.surfaces[0].material: unknown material; did you mean wet? known are glass, "
            "metal, plastic, wood, rubber, wet (\"weet\")");
  EXPECT_EQ(refused(R"("part": "flor", "material": "rubber")"),
            "object.surfaces[0].part: no part of the mesh file is called that; did you mean floor? "
            "it has rubber_coat floor, steel walls (flor)");
  EXPECT_EQ(refused(R"("inside": {"shape": "sphere", "radius": 0.01}, "material": "rubber")"),
            "object.surfaces[0]: must meet the surface ({\"inside\":{\"radius\":0.01,"
            "\"shape\":\"sphere\"},\"material\":\"rubbe...)");
  EXPECT_EQ(
      refused(R"("material": "rubber")"),
      "object.surfaces[0]: needs one of part, color, inside, beyond ({\"material\":\"rubber\"})");
  EXPECT_EQ(refused(R"("part": "floor")"), "object.surfaces[0].material: must be given");
  EXPECT_EQ(refused(R"("part": "floor", "material": "wet")",
                    R"(, "materials": {"wet": {"like": "glass", "friction": -1}})"),
            "materials.wet.friction: must be from 0 to 1e6 (-1.000000)");
  EXPECT_EQ(refused(R"("part": "floor", "material": "glass")",
                    R"(, "materials": {"glass": {"like": "glass"}})")
                .find("materials.glass: is known already"),
            0U);
  EXPECT_EQ(surface_refusal(tray_scene("", R"(, "link_surfaces": {"left_plat": []})")),
            "link_surfaces.left_plat: the hand has no such link; did you mean left_plate? it has "
            "palm, left_plate, right_plate ([])");
}

}  // namespace
}  // namespace prehend
