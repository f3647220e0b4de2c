// Colours of vertices, faces and materials, in each format and type of number that has them.
#include "sim/shape/files/mesh_color.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/shape/files/mesh_file.h"
#include "tests/sim/shape/files/mesh_samples.h"
#include "tests/support/colored_stick.h"
#include "tests/support/refusal_of.h"

namespace prehend {
namespace {

using test::replaced;

constexpr float kColorRounding = 1e-6F;  // single precision

ColoredMesh colors_of(const std::string& name, const std::string& bytes) {
  return read_mesh(bytes, name, {.colors = true}).colors;
}

// All four triangles of the sample, in the order of the file; NaN for none.
void expect_colors(const ColoredMesh& mesh, const std::vector<Eigen::Vector3f>& expected) {
  ASSERT_EQ(mesh.colors.size(), expected.size());
  ASSERT_EQ(mesh.surface.triangles.size(), expected.size());
  for (std::size_t t = 0; t < expected.size(); ++t) {
    EXPECT_EQ(mesh.colors[t].has_value(), !expected[t].hasNaN()) << t;
    if (!mesh.colors[t]) continue;
    EXPECT_LT((*mesh.colors[t] - expected[t]).norm(), kColorRounding)
        << t << ": " << mesh.colors[t]->transpose();
  }
}

// The corners of the sample's triangles: 021, 013, 123, 032.
std::vector<Eigen::Vector3f> means_of(const std::vector<Eigen::Vector3f>& of) {
  return {(of[0] + of[2] + of[1]) / 3, (of[0] + of[1] + of[3]) / 3, (of[1] + of[2] + of[3]) / 3,
          (of[0] + of[3] + of[2]) / 3};
}

std::string refusal_of_colors(const std::string& name, const std::string& bytes) {
  EXPECT_NO_THROW((void)read_mesh(bytes, name)) << "without colours nothing is refused";
  return test::refusal_of([&] { (void)colors_of(name, bytes); }).what();
}

const float kNoColor = std::numeric_limits<float>::quiet_NaN();
const std::vector<Eigen::Vector3f> kFour = {{1, 0, 0}, {0.2F, 0.4F, 0.6F}, {0, 0, 1}, {1, 1, 1}};

// The PLY sample whose vertices or faces have these words after their own.
std::string ply_with(const std::string& element, const std::string& properties,
                     const std::vector<std::string>& words) {
  std::string text = test::ply_sample();
  const bool of_vertices = element == "vertex";
  text = replaced(text, of_vertices ? "element face" : "end_header",
                  properties + (of_vertices ? "element face" : "end_header"));
  const std::vector<std::string> lines =
      of_vertices ? std::vector<std::string>{"\n0 0 0", "\n1 0 0", "\n0 2 0", "\n0 0 3"}
                  : std::vector<std::string>{"\n3 0 2 1", "\n3 0 1 3", "\n3 1 2 3", "\n3 0 3 2"};
  for (std::size_t i = 0; i < 4; ++i) text = replaced(text, lines[i], lines[i] + " " + words[i]);
  return text;
}

std::string rgb(const std::string& type) {
  return "property " + type + " red\nproperty " + type + " green\nproperty " + type + " blue\n";
}

TEST(MeshColors, OfPlyVerticesHaveAnyOfTheirTypes) {
  const auto expected = means_of(kFour);
  expect_colors(colors_of("a.ply", ply_with("vertex", rgb("uchar"),
                                            {"255 0 0", "51 102 153", "0 0 255", "255 255 255"})),
                expected);
  expect_colors(colors_of("a.ply", ply_with("vertex", rgb("ushort"),
                                            {"65535 0 0", "13107 26214 39321", "0 0 65535",
                                             "65535 65535 65535"})),
                expected);
  for (const char* type : {"float", "double"}) {
    expect_colors(colors_of("a.ply", ply_with("vertex", rgb(type),
                                              {"1 0 0", "0.2 0.4 0.6", "0 0 1", "1 1 1"})),
                  expected);
  }
}

TEST(MeshColors, OfPlyFacesAreThoseOfTheirTriangles) {
  expect_colors(colors_of("a.ply", ply_with("face", rgb("float"),
                                            {"1 0 0", "0.2 0.4 0.6", "0 0 1", "1 1 1"})),
                kFour);
  const ColoredMesh stick = colors_of("stick.ply", test::colored_stick());
  ASSERT_EQ(stick.colors.size(), 20U);
  EXPECT_EQ(color_text(stick.colors.front()->cast<double>()), test::kLowerColor);
  EXPECT_EQ(color_text(stick.colors.back()->cast<double>()), test::kUpperColor);
}

TEST(MeshColors, OfPlyThatAreNoneAreRefused) {
  EXPECT_EQ(refusal_of_colors(
                "a.ply", ply_with("vertex", rgb("float"), {"1 0 0", "1 0 nan", "0 0 1", "1 1 1"})),
            "a.ply: line 14: blue must be from 0 to 1, not nan");
  EXPECT_EQ(refusal_of_colors(
                "a.ply", ply_with("face", rgb("uchar"), {"1 256 0", "1 0 0", "0 0 1", "1 1 1"})),
            "a.ply: line 17: green must be from 0 to 255, not 256");
  EXPECT_EQ(refusal_of_colors("a.ply",
                              ply_with("vertex", rgb("int"), {"1 0 0", "1 0 0", "0 0 1", "1 1 1"})),
            "a.ply: red of element vertex must be uchar, ushort, float or double");
  EXPECT_EQ(
      refusal_of_colors("a.ply", ply_with("vertex", "property uchar red\n", {"1", "1", "0", "1"})),
      "a.ply: element vertex must have one red, one green and one blue");
}

TEST(MeshColors, OfObjVerticesStandAfterTheirCoordinates) {
  const std::string all = "v 0 0 0 1 0 0\nv 1 0 0 0.2 0.4 0.6\nv 0 2 0 0 0 1\nv 0 0 3 1 1 1\n";
  const std::string faces = "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
  expect_colors(colors_of("a.obj", all + faces), means_of(kFour));
  expect_colors(colors_of("a.obj", faces + all), means_of(kFour));
  // One vertex has a weight alone, and its triangles no colour.
  auto expected = means_of(kFour);
  for (const std::size_t t : {1U, 2U, 3U}) expected[t].fill(kNoColor);
  expect_colors(colors_of("a.obj", replaced(all, "3 1 1 1", "3 1") + faces), expected);
  EXPECT_EQ(refusal_of_colors("a.obj", replaced(all, "1 1 1", "1 1") + faces),
            "a.obj: line 4: a vertex has 2 numbers after its coordinates, a colour has 3");
  EXPECT_EQ(refusal_of_colors("a.obj", replaced(all, "1 1 1", "1 1 1 1") + faces),
            "a.obj: line 4: a vertex has more than 3 numbers after its coordinates, a colour has "
            "3");
  for (const char* word : {"nan", "1.5", "-0.1", "red"}) {
    EXPECT_EQ(
        refusal_of_colors("a.obj", replaced(all, "1 1 1", std::string("1 1 ") + word) + faces),
        std::string("a.obj: line 4: a colour must have numbers from 0 to 1 ('") + word + "')");
  }
}

// The binary glTF of this text and these bytes.
std::string glb_of_json(std::string json, std::string data) {
  json.resize((json.size() + 3) / 4 * 4, ' ');
  data.resize((data.size() + 3) / 4 * 4);
  std::string bytes = "glTF";
  test::append_value<std::uint32_t>(bytes, 2);
  test::append_value(bytes, static_cast<std::uint32_t>(28 + json.size() + data.size()));
  test::append_value(bytes, static_cast<std::uint32_t>(json.size()));
  test::append_value<std::uint32_t>(bytes, 0x4E4F534A);
  bytes += json;
  test::append_value(bytes, static_cast<std::uint32_t>(data.size()));
  test::append_value<std::uint32_t>(bytes, 0x004E4942);
  return bytes + data;
}

// The sample's text with an accessor of colours behind its other data.
std::string json_with_colors(std::size_t bytes, int type, const char* kind, int count) {
  std::string text =
      replaced(test::gltf_json(""), R"("POSITION":0)", R"("POSITION":0,"COLOR_0":2)");
  text = replaced(text, R"("type":"SCALAR"})",
                  R"("type":"SCALAR"},{"bufferView":2,"normalized":true,"componentType":)" +
                      std::to_string(type) + R"(,"count":)" + std::to_string(count) +
                      R"(,"type":")" + kind + "\"}");
  text = replaced(text, R"("byteLength":24}])",
                  R"("byteLength":24},{"buffer":0,"byteOffset":72,"byteLength":)" +
                      std::to_string(bytes) + "}]");
  return replaced(text, R"("byteLength":72}])",
                  R"("byteLength":)" + std::to_string(72 + bytes) + "}]");
}

std::string glb_with(const std::string& colors, int type, const char* kind, int count = 4) {
  return glb_of_json(json_with_colors(colors.size(), type, kind, count),
                     test::gltf_buffer() + colors);
}

std::string with_material(const std::string& gltf, const std::string& factor) {
  return replaced(
      replaced(gltf, R"("indices":1)", R"("indices":1,"material":0)"), R"("meshes")",
      R"("materials":[{"pbrMetallicRoughness":{"baseColorFactor":)" + factor + R"(}}],"meshes")");
}

template <typename Value>
std::string color_bytes(const std::vector<std::vector<Value>>& colors) {
  std::string bytes;
  for (const std::vector<Value>& color : colors) {
    for (const Value part : color) test::append_value(bytes, part);
  }
  return bytes;
}

Eigen::Vector3f shown(float r, float g, float b) {
  return {shown_part(r), shown_part(g), shown_part(b)};
}

TEST(MeshColors, OfGltfVerticesAreLight) {
  const std::vector<Eigen::Vector3f> expected =
      means_of({shown(1, 0, 0), shown(0.2F, 0.4F, 0.6F), shown(0, 0, 1), shown(1, 1, 1)});
  expect_colors(
      colors_of("a.glb",
                glb_with(color_bytes<float>({{1, 0, 0}, {0.2F, 0.4F, 0.6F}, {0, 0, 1}, {1, 1, 1}}),
                         5126, "VEC3")),
      expected);
  expect_colors(
      colors_of(
          "a.glb",
          glb_with(color_bytes<std::uint8_t>(
                       {{255, 0, 0, 9}, {51, 102, 153, 9}, {0, 0, 255, 9}, {255, 255, 255, 9}}),
                   5121, "VEC4")),
      expected);
  const std::string shorts = color_bytes<std::uint16_t>(
      {{65535, 0, 0}, {13107, 26214, 39321}, {0, 0, 65535}, {65535, 65535, 65535}});
  expect_colors(colors_of("a.glb", glb_with(shorts, 5123, "VEC3")), expected);
  // A material's factor is multiplied with them.
  const std::string json =
      with_material(json_with_colors(shorts.size(), 5123, "VEC3", 4), "[0.5, 1, 0.5, 1]");
  expect_colors(colors_of("a.glb", glb_of_json(json, test::gltf_buffer() + shorts)),
                means_of({shown(0.5F, 0, 0), shown(0.1F, 0.4F, 0.3F), shown(0, 0, 0.5F),
                          shown(0.5F, 1, 0.5F)}));
  // The first value is on the straight part of the curve, the second from tables of sRGB.
  EXPECT_NEAR(shown_part(0.001F), 0.01292F, kColorRounding);
  EXPECT_NEAR(shown_part(0.2140411F), 0.5F, 1e-5F);
}

TEST(MeshColors, OfGltfMaterialsAreThoseOfTheirTriangles) {
  const auto made_of = [](const std::string& factor) {
    return glb_of_json(with_material(test::gltf_json(""), factor), test::gltf_buffer());
  };
  expect_colors(colors_of("a.glb", made_of("[0.5, 0.25, 0, 1]")),
                std::vector<Eigen::Vector3f>(4, shown(0.5F, 0.25F, 0)));
  EXPECT_TRUE(colors_of("a.glb", test::glb_sample()).empty());
  EXPECT_NE(refusal_of_colors("a.glb", made_of("[0.5, 0.25, 2, 1]"))
                .find("baseColorFactor: must be from 0 to 1 (2)"),
            std::string::npos);
}

TEST(MeshColors, OfGltfThatAreNoneAreRefused) {
  const auto refused = [](const std::string& text, const std::string& words) {
    EXPECT_EQ(refusal_of_colors("a.glb", text), "a.glb: COLOR_0: " + words);
  };
  refused(glb_with(color_bytes<float>({{1, 0, 0}, {1, 0, 0}, {1, 0, 0}}), 5126, "VEC3", 3),
          "has 3 colours of 4 vertices");
  refused(glb_with(color_bytes<float>({{1, 0, 0}, {1, 0, kNoColor}, {1, 0, 0}, {1, 0, 0}}), 5126,
                   "VEC3"),
          "must be from 0 to 1 (nan)");
  refused(glb_with(color_bytes<std::int16_t>({{1, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1, 0, 0}}), 5122,
                   "VEC3"),
          "must be three or four floats or unsigned numbers");
}

TEST(MeshColors, OfColladaAreDiffuse) {
  std::string text = replaced(test::dae_sample(), "<triangles ", "<triangles material=\"red\" ");
  text = replaced(text, "<library_geometries>",
                  "<library_effects><effect id=\"e\"><profile_COMMON><technique><phong><diffuse>"
                  "<color>0.2 0.4 0.6 1</color></diffuse></phong></technique></profile_COMMON>"
                  "</effect></library_effects><library_materials><material id=\"m\">"
                  "<instance_effect url=\"#e\"/></material></library_materials>"
                  "<library_geometries>");
  EXPECT_TRUE(colors_of("a.dae", text).empty()) << "nothing says that red is m";
  const std::vector<Eigen::Vector3f> expected(4, {0.2F, 0.4F, 0.6F});
  expect_colors(colors_of("a.dae", replaced(text, "\"red\"", "\"m\"")), expected);
  const std::string bound = replaced(
      text, "<instance_geometry url=\"#g\"/>",
      "<instance_geometry url=\"#g\"><bind_material><technique_common><instance_material "
      "symbol=\"red\" target=\"#m\"/></technique_common></bind_material></instance_geometry>");
  expect_colors(colors_of("a.dae", bound), expected);
  EXPECT_NE(refusal_of_colors("a.dae", replaced(bound, "0.2 0.4", "0.2 4"))
                .find("<color>: must be from 0 to 1 (4)"),
            std::string::npos);
  EXPECT_NE(refusal_of_colors("a.dae", replaced(bound, "0.2 0.4 0.6 1", "0.2 0.4"))
                .find("<color>: must have 3 or 4 numbers"),
            std::string::npos);
}

TEST(MeshColors, AreKeptOnlyWhereTheyAreAskedFor) {
  EXPECT_TRUE(read_mesh(test::colored_stick(), "stick.ply").colors.empty());
  EXPECT_TRUE(colors_of("a.ply", test::ply_sample()).empty());
  EXPECT_TRUE(colors_of("a.obj", test::obj_sample()).empty());
  EXPECT_TRUE(colors_of("a.stl", test::text_stl_sample()).empty());
}

TEST(MeshColors, AreWrittenAsDigits) {
  for (int i = 0; i < 256; ++i) {
    const Vector3 color(i / 255.0, (255 - i) / 255.0, 0.0);
    EXPECT_EQ(color_in_text(color_text(color)), color);
  }
  EXPECT_EQ(color_text({0.8, 0.2, 17 / 255.0}), "#cc3311");
  EXPECT_EQ(color_in_text("#CC3311"), color_in_text("#cc3311"));
  for (const char* word :
       {"", "#", "cc3311", "#cc331", "#cc33111", "#cc33g1", "#cc 311", "#-c3311"}) {
    EXPECT_FALSE(color_in_text(word)) << word;
  }
}

TEST(FrequentColors, AreListedByTheirSurface) {
  const std::vector<ColorShare> two = frequent_colors(colors_of("a.ply", test::colored_stick()));
  ASSERT_EQ(two.size(), 2U);
  EXPECT_NEAR(two[0].share, 0.5, 1e-6);
  EXPECT_NEAR(two[1].share, 0.5, 1e-6);
  // Colours about the same count as one: 90 of 100 triangles differ by up to 0.08 from it.
  ColoredMesh strip;
  for (int i = 0; i <= 100; ++i) {
    for (const double y : {0.0, 1.0}) strip.surface.vertices.emplace_back(i, y, 0.0);
  }
  for (int i = 0; i < 100; ++i) {
    strip.surface.triangles.push_back({2 * i, 2 * i + 1, 2 * i + 2});
    const float part =
        i < 10 ? 0.1F * static_cast<float>(i) : 0.4F + 0.0008F * static_cast<float>(i);
    strip.colors.emplace_back(Eigen::Vector3f(part, i < 10 ? 0.0F : 1.0F, 0.0F));
  }
  const std::vector<ColorShare> many = frequent_colors(strip);
  ASSERT_EQ(many.size(), 5U);
  EXPECT_NEAR(many[0].share, 0.9, 1e-9);
  EXPECT_NEAR(many[0].color.x(), 0.44, 0.05);
  EXPECT_TRUE(frequent_colors({}).empty());
}

}  // namespace
}  // namespace prehend
