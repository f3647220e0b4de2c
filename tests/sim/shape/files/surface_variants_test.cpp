// Ways in which formats may write the same surface: strips, fans and instances of glTF, prefixes of
// OFF, lists of polygons and references of COLLADA. They are read right or refused, never read as
// another surface.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/shape/files/mesh_file.h"
#include "tests/sim/shape/files/mesh_samples.h"
#include "tests/support/refusal_of.h"
#include "tests/support/test_meshes.h"

namespace prehend {
namespace {

using test::replaced;
using test::written;

// Parts of a glTF file that has one buffer: points, then indices of 16 bits.
struct GltfParts {
  std::vector<std::vector<float>> points = test::sample_points();
  std::vector<std::uint16_t> indices = test::sample_indices();
  std::string primitives = R"({"attributes":{"POSITION":0},"indices":1})";
  std::string nodes = R"({"mesh":0})";
  std::string roots = "0";
};

std::string glb_of(const GltfParts& parts) {
  std::string data;
  for (const auto& point : parts.points) {
    for (const float x : point) test::append_value(data, x);
  }
  const std::string points = std::to_string(data.size());
  for (const std::uint16_t index : parts.indices) test::append_value(data, index);
  const std::string indices = std::to_string(2 * parts.indices.size());
  data.resize((data.size() + 3) / 4 * 4);
  std::string json = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[)" + parts.roots +
                     R"(]}],"nodes":[)" + parts.nodes + R"(],"meshes":[{"primitives":[)" +
                     parts.primitives +
                     R"(]}],"accessors":[{"bufferView":0,"componentType":5126,"count":)" +
                     std::to_string(parts.points.size()) +
                     R"(,"type":"VEC3"},{"bufferView":1,"componentType":5123,"count":)" +
                     std::to_string(parts.indices.size()) +
                     R"(,"type":"SCALAR"}],"bufferViews":[{"buffer":0,"byteLength":)" + points +
                     R"(},{"buffer":0,"byteOffset":)" + points + R"(,"byteLength":)" + indices +
                     R"(}],"buffers":[{"byteLength":)" + std::to_string(data.size()) + "}]}";
  json.resize((json.size() + 3) / 4 * 4, ' ');
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

// A closed surface of any number of parts that faces outward, of this volume and between these
// corners.
void expect_solid(const std::filesystem::path& file, double volume, const Vector3& lower,
                  const Vector3& upper) {
  SCOPED_TRACE(file.string());
  const TriangleMesh mesh = load_mesh(file).mesh;
  const MeshChecks checks = check_mesh(mesh);
  EXPECT_TRUE(checks.solid());
  EXPECT_FALSE(checks.inward);
  EXPECT_NEAR(signed_volume(mesh), volume, 1e-5 * volume);
  EXPECT_LT((bounds(mesh).lower - lower).norm(), 1e-6) << bounds(mesh).lower.transpose();
  EXPECT_LT((bounds(mesh).upper - upper).norm(), 1e-6) << bounds(mesh).upper.transpose();
}

void expect_sample(const std::string& name, const std::string& bytes) {
  expect_solid(written(name, bytes), 1.0, Vector3::Zero(), Vector3(1, 2, 3));
}

// The corners of a box of 1 x 2 x 3: corner x + 2 y + 4 z, and its surface as one strip.
std::vector<std::vector<float>> box_corners() {
  std::vector<std::vector<float>> corners;
  for (int i = 0; i < 8; ++i) {
    corners.push_back(
        {static_cast<float>(i & 1), static_cast<float>(i & 2), static_cast<float>(3 * (i >> 2))});
  }
  return corners;
}

const std::vector<std::uint16_t> kBoxStrip = {6, 7, 2, 3, 1, 7, 5, 6, 4, 2, 0, 1, 4, 5};

TEST(GltfSurface, OfAStripTurnsEverySecondTriangle) {
  GltfParts strip{box_corners(), kBoxStrip};
  strip.primitives = R"({"attributes":{"POSITION":0},"indices":1,"mode":5})";
  expect_solid(written("strip.glb", glb_of(strip)), 6.0, Vector3::Zero(), Vector3(1, 2, 3));
  // Without indices, the points themselves are the strip.
  GltfParts plain = strip;
  plain.points.clear();
  for (const std::uint16_t i : kBoxStrip) plain.points.push_back(strip.points[i]);
  plain.primitives = R"({"attributes":{"POSITION":0},"mode":5})";
  expect_solid(written("plain.glb", glb_of(plain)), 6.0, Vector3::Zero(), Vector3(1, 2, 3));
}

// Triangles without area join two strips; they count when every second one is turned.
TEST(GltfSurface, OfAStripMayHaveTrianglesWithoutArea) {
  GltfParts strip{box_corners(), {kBoxStrip.begin(), kBoxStrip.begin() + 7}};
  strip.indices.insert(strip.indices.end(), {kBoxStrip[6], kBoxStrip[5]});
  strip.indices.insert(strip.indices.end(), kBoxStrip.begin() + 5, kBoxStrip.end());
  strip.primitives = R"({"attributes":{"POSITION":0},"indices":1,"mode":5})";
  expect_solid(written("joined.glb", glb_of(strip)), 6.0, Vector3::Zero(), Vector3(1, 2, 3));
}

// Three faces around the corner at (0, 0, 3) as a fan, the fourth as a list.
TEST(GltfSurface, OfAFanHasAllTrianglesAtTheFirstPoint) {
  GltfParts fan;
  fan.points = {{0, 0, 3}, {0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 0}};
  fan.indices = {1, 3, 2};
  fan.primitives = R"({"attributes":{"POSITION":0},"mode":6},)"
                   R"({"attributes":{"POSITION":0},"indices":1,"mode":4})";
  expect_sample("fan.glb", glb_of(fan));
  fan.points = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}};
  fan.indices = {3, 0, 1, 2, 0};
  fan.primitives = R"({"attributes":{"POSITION":0},"indices":1,"mode":6})";
  const TriangleMesh open = load_mesh(written("open.glb", glb_of(fan))).mesh;
  EXPECT_EQ(open.triangles.size(), 3U);
  // All but the face at z = 0: areas 1.5, 3, and 3.5 of the slanted one.
  EXPECT_NEAR(surface_area(open), 1.5 + 3.0 + 3.5, 1e-6);
}

TEST(GltfSurface, OfLinesAndPointsIsNone) {
  for (const int mode : {0, 1, 2, 3}) {
    GltfParts lines;
    lines.primitives =
        R"({"attributes":{"POSITION":0},"indices":1,"mode":)" + std::to_string(mode) + "}";
    const auto file = written("lines" + std::to_string(mode) + ".glb", glb_of(lines));
    EXPECT_NE(test::refusal_of([&] { (void)load_mesh(file); }).problem(), "") << mode;
  }
}

TEST(GltfSurface, OfTwoNodesWithOneMeshIsThereTwice) {
  GltfParts twice;
  twice.roots = "0,1";
  // The second one is turned by 90 degrees about z, doubled and moved.
  twice.nodes = R"({"mesh":0},{"mesh":0,"translation":[10,0,0],"scale":[2,2,2],)"
                R"("rotation":[0,0,0.70710678118,0.70710678118]})";
  expect_solid(written("twice.glb", glb_of(twice)), 1.0 + 8.0, Vector3::Zero(), Vector3(10, 2, 6));
}

TEST(GltfSurface, OfMirroredNodesFacesOutward) {
  GltfParts mirrored;
  mirrored.nodes = R"({"mesh":0,"scale":[-1,1,1]})";
  expect_solid(written("one.glb", glb_of(mirrored)), 1.0, Vector3(-1, 0, 0), Vector3(0, 2, 3));
  mirrored.nodes = R"({"mesh":0,"scale":[-1,-1,1]})";
  expect_solid(written("two.glb", glb_of(mirrored)), 1.0, Vector3(-1, -2, 0), Vector3(0, 0, 3));
  mirrored.nodes = R"({"mesh":0,"scale":[-1,-1,-1]})";
  expect_solid(written("three.glb", glb_of(mirrored)), 1.0, Vector3(-1, -2, -3), Vector3(0, 0, 0));
  // A mirrored child of a mirrored node is not mirrored.
  mirrored.nodes = R"({"children":[1],"scale":[-1,1,1]},{"mesh":0,"scale":[-1,1,1]})";
  expect_sample("child.glb", glb_of(mirrored));
  mirrored.nodes = R"({"mesh":0,"matrix":[-1,0,0,0, 0,1,0,0, 0,0,1,0, 5,0,0,1]})";
  expect_solid(written("matrix.glb", glb_of(mirrored)), 1.0, Vector3(4, 0, 0), Vector3(5, 2, 3));
}

// OFF with more words on each line of a vertex.
std::string off_with(const std::string& keyword, const std::string& words) {
  return keyword + "\n4 4 0\n0 0 0" + words + "\n1 0 0" + words + "\n0 2 0" + words + "\n0 0 3" +
         words + "\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
}

TEST(OffSurface, IsReadWithColoursNormalsAndTextureCoordinates) {
  expect_sample("c.off", off_with("COFF", " 0.5 0.5 0.5 1"));
  expect_sample("c8.off", off_with("COFF", " 255 0 0"));
  expect_sample("n.off", off_with("NOFF", " 0 0 1"));
  expect_sample("st.off", off_with("STOFF", " 0.1 0.9"));
  expect_sample("cn.off", off_with("CNOFF", " 0 0 1 1 0 0 1"));
  expect_sample("stcn.off", off_with("STCNOFF", " 0 0 1 1 0 0 1 0.1 0.9"));
  expect_sample("face.off", replaced(test::off_sample(), "3 0 2 1\n", "3 0 2 1 0.3 0.3 0.3\n"));
}

TEST(OffSurface, OfOtherDimensionsIsRefused) {
  const std::string refused = "only three-dimensional text OFF can be read";
  for (const char* keyword : {"4OFF", "C4OFF", "nOFF", "4nOFF", "OFF BINARY"}) {
    const auto file = written("other.off", off_with(keyword, " 1"));
    const std::string problem = test::refusal_of([&] { (void)load_mesh(file); }).problem();
    EXPECT_NE(problem.find(refused), std::string::npos) << keyword << ": " << problem;
  }
}

// The sample with another element in place of its triangles.
std::string dae_with(const std::string& surface) {
  std::string text = test::dae_sample();
  const std::size_t start = text.find("<triangles");
  const std::string end = "</triangles>";
  return text.replace(start, text.find(end) + end.size() - start, surface);
}

const std::string kInput = R"(<input semantic="VERTEX" source="#v" offset="0"/>)";

TEST(ColladaSurface, IsReadFromListsOfPolygons) {
  expect_sample("polylist.dae",
                dae_with(R"(<polylist count="4">)" + kInput +
                         "<vcount>3 3 3 3</vcount><p>0 2 1 0 1 3 1 2 3 0 3 2</p></polylist>"));
  expect_sample("polygons.dae", dae_with(R"(<polygons count="4">)" + kInput +
                                         "<p>0 2 1</p><p>0 1 3</p><p>1 2 3</p><p>0 3 2</p>"
                                         "</polygons>"));
}

void expect_unsupported(const std::string& name, const std::string& surface) {
  const auto file = written("refused.dae", dae_with(surface));
  const std::string error = test::refusal_of([&] { (void)load_mesh(file); }).what();
  EXPECT_NE(error.find("<" + name + ">: is not supported"), std::string::npos) << error;
}

TEST(ColladaSurface, WithHolesIsRefused) {
  expect_unsupported(
      "ph", R"(<polygons count="1">)" + kInput + "<ph><p>0 1 2</p><h>0 1 3</h></ph></polygons>");
}

TEST(ColladaSurface, OfStripsTurnsEverySecondTriangle) {
  expect_sample("strips.dae", dae_with(R"(<tristrips count="2">)" + kInput +
                                       "<p>0 2 1 3</p><p>1 3 0 2</p></tristrips>"));
}

// As one polygon, the side of a pyramid would be cut into other triangles.
TEST(ColladaSurface, OfFansIsRefused) {
  expect_unsupported("trifans", R"(<trifans count="1">)" + kInput + "<p>3 0 1 2</p></trifans>");
}

TEST(ColladaSurface, IsThereForEveryNodeThatRefersToIt) {
  const std::string shared =
      replaced(replaced(test::dae_sample(), R"(<library_visual_scenes>)",
                        R"(<library_nodes><node id="part"><instance_geometry url="#g"/></node>)"
                        R"(</library_nodes><library_visual_scenes>)"),
               R"(<node id="n"><instance_geometry url="#g"/></node>)",
               R"(<node id="a"><instance_node url="#part"/></node>)"
               R"(<node id="b"><translate>10 0 0</translate><scale>-2 2 2</scale>)"
               R"(<instance_node url="#part"/></node>)");
  expect_solid(written("shared.dae", shared), 9.0, Vector3::Zero(), Vector3(10, 4, 6));
}

// All kinds of transforms, in the order in which they are written.
TEST(ColladaSurface, IsWhereTheTransformsOfItsNodePutIt) {
  const std::string moved =
      replaced(test::dae_sample(), "<instance_g",
               "<translate>5 0 0</translate><rotate>0 0 2 90</rotate><scale>1 1 2</scale>"
               "<matrix>1 0 0 1 0 1 0 0 0 0 1 0 0 0 0 1</matrix>"
               "<lookat>0 0 0 0 0 -1 0 1 0</lookat><instance_g");
  expect_solid(written("moved.dae", moved), 2.0, Vector3(3, 1, 0), Vector3(5, 2, 6));
}

// A skin is read in the shape in which it was modelled.
TEST(ColladaSurface, OfAControllerIsThatOfItsGeometry) {
  const std::string skinned = replaced(
      replaced(test::dae_sample(), "<library_visual_scenes>",
               R"(<library_controllers><controller id="c"><skin source="#g"/></controller>)"
               R"(</library_controllers><library_visual_scenes>)"),
      R"(<instance_geometry url="#g"/>)", R"(<instance_controller url="#c"/>)");
  expect_sample("skin.dae", skinned);
}

TEST(ColladaSurface, IsInTheUnitOfTheFileAndInItsAxes) {
  const std::string inch =
      replaced(replaced(test::dae_sample(), R"(meter="1")", R"(meter="0.0254")"), "Z_UP", "Y_UP");
  expect_solid(written("inch.dae", inch), 0.0254 * 0.0254 * 0.0254, Vector3::Zero(),
               0.0254 * Vector3(1, 2, 3));
}

}  // namespace
}  // namespace prehend
