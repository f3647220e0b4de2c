// Parts of surfaces by the colours of their files, as scene files and programs state them.
#include "sim/scene/color_region.h"

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sim/base/random.h"
#include "sim/scene/compiled_scene.h"
#include "sim/scene/scene_file.h"
#include "sim/scene/scene_text.h"
#include "sim/shape/mesh_checks.h"
#include "tests/support/colored_stick.h"
#include "tests/support/refusal_of.h"

namespace prehend {
namespace {

namespace fs = std::filesystem;

// A scene of the stick, open at the top, in a file called after the test.
fs::path colored_scene(const std::string& object_fields, const std::string& fields = "") {
  const fs::path folder = testing::TempDir();
  std::ofstream(folder / "colored_stick.ply") << test::colored_stick(true);
  const std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
  const fs::path file = folder / ("colored_" + name + ".json");
  std::ofstream(file) << R"({"object": {"mesh": "colored_stick.ply")" << object_fields
                      << R"(}, "hand": "parallel_jaw")" << fields << "}";
  return file;
}

std::string color_refusal(const fs::path& file, const ObjectChoice& choice = {}) {
  const std::string words =
      test::refusal_of([&] { (void)load_scene(file, {.hand = "", .choice = choice}); }).what();
  const std::string name = file.string();
  return words.starts_with(name) ? words.substr(name.size() + 2) : words;
}

ColorRange color_range(const char* text, double within = ColorRange::kWithin) {
  return {*color_in_text(text), within};
}

TEST(ColorRange, HasColoursUpToItsDistance) {
  Random random(11);
  for (int i = 0; i < 1000; ++i) {
    const ColorRange range{Vector3::Constant(0.5), random.uniform(0.0, 0.4)};
    const double distance = random.uniform(0.0, 0.45);
    const Vector3 color = range.color + distance * random.direction();
    if (std::abs(distance - range.within) < 1e-5) continue;
    EXPECT_EQ(is_within(range, color.cast<float>()), distance < range.within);
  }
  // The colour itself, whatever single precision makes of it.
  EXPECT_TRUE(is_within(color_range("#cc3311", 0.0),
                        Eigen::Vector3f(204.0F / 255.0F, 51.0F / 255.0F, 17.0F / 255.0F)));
  EXPECT_FALSE(is_within(color_range("#cc3311", ColorRange::kFarthest), std::nullopt));
}

TEST(ColorRegion, IsTheSurfaceOfTheFileWithThatColour) {
  const Scene scene = load_scene(colored_scene(R"(, "keep_out": [{"color": "#cc3311"}],
      "preferred": [{"color": [0.13, 0.4, 0.67], "within": 0.05}],
      "porous": [{"color": "#000000", "within": 2}])"));
  EXPECT_EQ(scene.keep_out[0].surface.triangles.size(), 10U);
  EXPECT_LT(bounds(scene.keep_out[0].surface).upper.z(), 1e-9);
  EXPECT_EQ(scene.preferred[0].surface.triangles.size(), 8U);
  EXPECT_GT(bounds(scene.preferred[0].surface).lower.z(), -1e-9);
  EXPECT_EQ(scene.porous[0].surface.triangles.size(), 18U);
  const CompiledScene compiled = compile(scene);
  for (const double z : {-0.07, -0.01, 0.01, 0.07}) {
    const Vector3 side(0.015, 0.003, z);
    EXPECT_EQ(compiled.keep_out.contain(side), z < 0.0);
    EXPECT_EQ(compiled.preferred.contain(side), z > 0.0);
    EXPECT_FALSE(compiled.keep_out.contain({0.0, 0.0, z})) << "inside";
  }
}

// The repair closes the top, which has no triangle in the file: it has the colour around it.
TEST(ColorRegion, OfARepairedMeshHasWhatClosesItsHoles) {
  const Scene scene = load_scene(colored_scene(R"(, "material": "metal",
      "surfaces": [{"color": "#2266aa", "material": "rubber"}])"));
  EXPECT_TRUE(check_mesh(scene.object.mesh).solid());
  const CompiledScene compiled = compile(scene);
  const auto material_at = [&](const Vector3& p) { return compiled.object_surface.at(p).material; };
  EXPECT_EQ(material_at({0.001, 0.002, 0.075}), Material::rubber);
  EXPECT_EQ(material_at({0.015, 0.002, 0.03}), Material::rubber);
  EXPECT_EQ(material_at({0.015, 0.002, -0.03}), Material::metal);
  EXPECT_EQ(material_at({0.001, 0.002, -0.075}), Material::metal);
}

TEST(ColorRegion, OfAnObstacleAndOfAChoiceIsFound) {
  const fs::path file = colored_scene("", R"(, "obstacles": [{"name": "other",
      "mesh": "colored_stick.ply", "pose": {"position": [1, 0, 0]},
      "surfaces": [{"color": "#cc3311", "material": "rubber"}]}])");
  SurfaceRegion lower;
  lower.color = color_range(test::kLowerColor);
  const Scene scene = load_scene(file, {.hand = "", .choice = {.preferred = {lower}}});
  EXPECT_EQ(scene.preferred[0].surface.triangles.size(), 10U);
  EXPECT_EQ(scene.obstacles[0].surfaces[0].where.surface.triangles.size(), 10U);
  const Scene alone = load_scene(file.parent_path() / "colored_stick.ply",
                                 {.hand = "", .choice = {.keep_out = {lower}}});
  EXPECT_EQ(alone.keep_out[0].surface.triangles.size(), 10U);
}

TEST(ColorRegion, IsWrittenAndReadAgain) {
  const Scene first = load_scene(colored_scene(R"(, "keep_out": [{"color": "#CC3311"}],
      "preferred": [{"color": [0.13, 0.4, 0.67], "within": 0.05}],
      "surfaces": [{"color": "#2266aa", "within": 0.1, "material": "rubber"}])"));
  const std::string text = scene_text(first);
  const fs::path file = fs::path(testing::TempDir()) / "colored_again.json";
  std::ofstream(file) << text;
  EXPECT_EQ(scene_text(load_scene(file)), text);
  const nlohmann::json object = nlohmann::json::parse(text)["object"];
  EXPECT_EQ(object["keep_out"], nlohmann::json::parse(R"([{"color": "#cc3311"}])"));
  EXPECT_EQ(object["preferred"],
            nlohmann::json::parse(R"([{"color": [0.13, 0.4, 0.67], "within": 0.05}])"));
  EXPECT_EQ(object["surfaces"], nlohmann::json::parse(R"([{"color": "#2266aa", "within": 0.1,
                                                           "material": "rubber"}])"));
}

TEST(ColorRegion, MistakesNameTheFieldAndTheNextStep) {
  const auto refused = [](const std::string& region) {
    return color_refusal(colored_scene(R"(, "keep_out": [)" + region + "]"));
  };
  EXPECT_EQ(refused(R"({"color": "#00ff00"})"),
            "object.keep_out[0].color: no triangle has this colour; state one of the file's, most "
            "of it has #cc3311, #2266aa, or a larger \"within\" (#00ff00)");
  EXPECT_EQ(refused(R"({"color": "red"})"),
            "object.keep_out[0].color: must be a colour, such as \"#cc3311\": # and two "
            "hexadecimal digits each of red, green, blue, or three numbers from 0 to 1 (\"red\")");
  EXPECT_EQ(refused(R"({"color": [0, 2, 0]})"),
            "object.keep_out[0].color: each must be at least 0 and at most 1 ([0,2,0])");
  EXPECT_EQ(refused(R"({"color": "#cc3311", "within": 3})"),
            "object.keep_out[0].within: must be at least 0 and at most 2 (3)");
  EXPECT_EQ(refused(R"({"part": "lid", "within": 0.1})"),
            "object.keep_out[0].within: only beside color (0.1)");
  EXPECT_EQ(refused(R"({"part": "lid", "color": "#cc3311"})")
                .find("object.keep_out[0]: needs one of part, color, inside, beyond"),
            0U);
  EXPECT_EQ(color_refusal(colored_scene(R"(, "surfaces": [{"color": "#00ff00",
                                            "material": "rubber"}])"))
                .find("object.surfaces[0].color: no triangle has this colour"),
            0U);
  EXPECT_EQ(color_refusal(colored_scene("", R"(, "link_surfaces": {"left_plate": [
                                            {"color": "#cc3311", "material": "rubber"}]})"))
                .find("link_surfaces.left_plate: a link has no parts with names or colours"),
            0U);
  const fs::path plain = fs::path(testing::TempDir()) / "colorless.json";
  std::ofstream(plain) << R"({"object": {"generate": "ball", "keep_out": [{"color": "#cc3311"}]}})";
  EXPECT_EQ(color_refusal(plain),
            "object.keep_out[0].color: the object has no colours of vertices, faces or materials; "
            "state a shape that it is inside (#cc3311)");
}

}  // namespace
}  // namespace prehend
