// Regions of an object's surface, and the choice of one of several objects, as scene files state
// them.
#include "sim/scene/surface_region.h"

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/base/json/json_field.h"
#include "sim/base/random.h"
#include "sim/scene/compiled_scene.h"
#include "sim/scene/scene_file.h"
#include "sim/scene/scene_text.h"
#include "sim/shape/basic_shapes.h"
#include "sim/shape/files/mesh_file.h"
#include "tests/support/refusal_of.h"

namespace prehend {
namespace {

namespace fs = std::filesystem;

// A stick along x whose halves have names, and their material is that of the whole.
void write_stick(const fs::path& file) {
  std::ofstream obj(file);
  obj << "usemtl steel\n";
  int first = 1;
  for (const auto& [name, x] : {std::pair("left", -0.05), std::pair("right_half", 0.05)}) {
    obj << "o " << name << "\n";
    const TriangleMesh box = transformed(make_box({0.1, 0.02, 0.03}), translation({x, 0.0, 0.0}));
    for (const Vector3& v : box.vertices) {
      obj << "v " << v.x() << " " << v.y() << " " << v.z() << "\n";
    }
    for (const Triangle& t : box.triangles) {
      obj << "f " << t[0] + first << " " << t[1] + first << " " << t[2] + first << "\n";
    }
    first += static_cast<int>(box.vertices.size());
  }
}

fs::path stick_scene(const std::string& fields) {
  const fs::path folder = testing::TempDir();
  write_stick(folder / "stick.obj");
  const std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
  const fs::path file = folder / ("region_" + name + ".json");
  std::ofstream(file) << R"({"object": {"mesh": "stick.obj")" << fields << "}}";
  return file;
}

std::string refusal_of_scene(const fs::path& file, const ObjectChoice& choice = {}) {
  const std::string words =
      test::refusal_of([&] { (void)load_scene(file, {.hand = "", .choice = choice}); }).what();
  const std::string name = file.string();
  return words.starts_with(name) ? words.substr(name.size() + 2) : words;
}

TEST(SurfaceRegion, APartIsCalledByItsWholeNameItsMaterialOrItsOwn) {
  const fs::path file = fs::path(testing::TempDir()) / "stick.obj";
  write_stick(file);
  const std::vector<MeshPart> parts = load_mesh(file, {.part_surfaces = true}).parts;
  EXPECT_EQ(part_surface("left", parts).triangles.size(), 12U);
  EXPECT_EQ(part_surface("right_half", parts).triangles.size(), 12U);
  EXPECT_EQ(part_surface("steel right_half", parts).triangles.size(), 12U);
  EXPECT_EQ(part_surface("steel", parts).triangles.size(), 24U);
  EXPECT_STREQ(
      test::refusal_of([&] { (void)part_surface("eft", parts); }).what(),
      "no part of the mesh file is called that; did you mean left? it has steel left, steel "
      "right_half (eft)");
  EXPECT_TRUE(load_mesh(file).parts.front().surface.empty());
}

TEST(SurfaceRegion, HasThePointsInItsShapeAndNearItsPart) {
  SurfaceRegion inside;
  inside.inside = {Box{{0.02, 0.04, 0.06}}, translation({0.1, 0.0, 0.0})};
  const SurfaceRegion part{.part = "ball", .surface = make_sphere(0.05, 4)};
  const SurfaceRegions regions({inside, part});
  Random random(3);
  constexpr double kMargin = SurfaceRegions::kMargin;
  for (int i = 0; i < 500; ++i) {
    const Vector3 direction = random.direction();
    // The sphere's triangles are within 1 % of it.
    EXPECT_TRUE(regions.contain(part.surface.vertices[0]));
    EXPECT_FALSE(regions.contain(0.04 * direction));
    EXPECT_TRUE(regions.contain(0.0495 * direction, 0.002));
    const Vector3 p = Vector3(0.1, 0.0, 0.0) + 0.03 * direction;
    const Vector3 beyond = 0.03 * direction.cwiseAbs() - Vector3(0.01, 0.02, 0.03);
    if (std::abs(beyond.maxCoeff() - kMargin) < 1e-4) continue;
    if (std::abs(p.norm() - 0.05) < 0.002) continue;
    EXPECT_EQ(regions.contain(p), beyond.maxCoeff() < kMargin) << p.transpose();
  }
  EXPECT_TRUE(SurfaceRegions().empty());
}

TEST(SurfaceRegion, IsReadAndWrittenAgain) {
  const fs::path file = stick_scene(R"(, "keep_out": [{"part": "left"}],
      "preferred": [{"part": "right_half"}, {"inside": {"shape": "sphere", "radius": 0.02}}])");
  ObjectChoice choice;
  choice.keep_out.push_back({.part = "right_half"});
  for (const Scene& scene : {load_scene(file), load_scene([&] {
                               const fs::path again =
                                   fs::path(testing::TempDir()) / "region_again.json";
                               std::ofstream(again) << scene_text(load_scene(file));
                               return again;
                             }())}) {
    ASSERT_EQ(scene.keep_out.size(), 1U);
    EXPECT_EQ(scene.keep_out[0].part, "left");
    EXPECT_EQ(scene.keep_out[0].surface.triangles.size(), 12U);
    ASSERT_EQ(scene.preferred.size(), 2U);
    EXPECT_EQ(std::get<Sphere>(scene.preferred[1].inside.shape).radius, 0.02);
  }
  const Scene more = load_scene(file, {.hand = "", .choice = choice});
  ASSERT_EQ(more.keep_out.size(), 2U);
  EXPECT_EQ(more.keep_out[1].surface.triangles.size(), 12U);
  const CompiledScene compiled = compile(more);
  EXPECT_TRUE(compiled.keep_out.contain({0.05, 0.01, 0.0}));
  EXPECT_FALSE(compiled.preferred.contain({-0.05, 0.01, 0.0}));
}

TEST(SurfaceRegion, MistakesNameTheField) {
  EXPECT_EQ(refusal_of_scene(stick_scene(R"(, "keep_out": [{"part": "up"}])")),
            "object.keep_out[0].part: no part of the mesh file is called that; it has steel left, "
            "steel right_half (up)");
  EXPECT_EQ(refusal_of_scene(stick_scene(R"(, "preferred": [{}])")),
            "object.preferred[0]: needs one of part, color, inside, beyond ({})");
  EXPECT_EQ(refusal_of_scene(stick_scene(R"(, "preferred": [{"inside": {"shape": "bar", "points":
      [[0, 0, 0], [0, 0, 1]], "width": 0.1, "closed": false}}])")),
            "object.preferred[0].inside.shape: must be box, sphere, cylinder or cone (\"bar\")");
  ObjectChoice choice;
  choice.preferred.push_back({.part = "up"});
  EXPECT_EQ(refusal_of_scene(stick_scene(""), choice).find("preferred: no part of the mesh file"),
            0U);
  choice = {.object = "cup"};
  EXPECT_EQ(refusal_of_scene(stick_scene(""), choice),
            "object: the scene has no such object; it has object (cup)");
}

const char* const kTwo = R"({"objects": [
    {"name": "a", "geometry": [{"shape": "box", "size": [0.05, 0.05, 0.05]}], "mass": 0.2},
    {"name": "b", "generate": "ball", "pose": {"position": [0, 0.2, 0]}, "material": "wood"}],
  "obstacles": [{"name": "wall", "geometry": [{"shape": "box", "size": [0.1, 0.1, 0.1]}],
                 "pose": {"position": [1, 0, 0]}}]})";

TEST(SceneObjects, TheOthersAreObstacles) {
  const fs::path file = fs::path(testing::TempDir()) / "two_objects.json";
  std::ofstream(file) << kTwo;
  EXPECT_EQ(scene_objects(file), (std::vector<std::string>{"a", "b"}));
  const Scene first = load_scene(file);
  EXPECT_EQ(first.object.name, "a");
  EXPECT_EQ(first.object.mass, 0.2);
  ASSERT_EQ(first.obstacles.size(), 2U);
  const Scene second = load_scene(file, {.hand = "", .choice = {.object = "b"}});
  EXPECT_EQ(second.object.name, "b");
  EXPECT_EQ(second.object.X_WO.translation(), Vector3(0.0, 0.2, 0.0));
  EXPECT_EQ(first.obstacles.front().name, "b");
  EXPECT_EQ(first.obstacles.front().material, Material::wood);
  EXPECT_EQ(first.obstacles.back().name, "wall");
  EXPECT_EQ(second.obstacles.front().name, "a");
}

TEST(SceneObjects, NamesAreNeededAndDiffer) {
  const fs::path file = fs::path(testing::TempDir()) / "bad_objects.json";
  const auto refused = [&](const std::string& text) {
    std::ofstream(file) << text;
    return refusal_of_scene(file);
  };
  const std::string box = R"("geometry": [{"shape": "box", "size": [0.05, 0.05, 0.05]}])";
  EXPECT_EQ(refused(R"({"objects": [{)" + box + "}]}"), "objects[0].name: must be given");
  EXPECT_EQ(refused(R"({"objects": [{"name": "a", )" + box + R"(}, {"name": "a", )" + box + "}]}"),
            "objects[1].name: must be a name that no other object has (\"a\")");
  EXPECT_EQ(refused(R"({"objects": []})"), "objects: must have at least one object ([])");
  EXPECT_EQ(refused(R"({"objects": [{"name": "a", )" + box + R"(}], "object": {)" + box + "}}")
                .find("object: not beside \"objects\""),
            0U);
}

}  // namespace
}  // namespace prehend
