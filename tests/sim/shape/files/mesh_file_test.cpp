#include "sim/shape/files/mesh_file.h"

#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "sim/base/input_error.h"
#include "tests/sim/shape/files/mesh_samples.h"
#include "tests/support/refusal_of.h"
#include "tests/support/test_meshes.h"

namespace prehend {
namespace {

using test::replaced;
using test::written;

// The error must be one line that starts with the file and contains the phrase.
void expect_error(const std::filesystem::path& file, const std::string& phrase) {
  try {
    load_mesh(file);
    ADD_FAILURE() << file << " was read, expected: " << phrase;
  } catch (const InputError& error) {
    const std::string text = error.what();
    EXPECT_TRUE(text.starts_with(file.string() + ": ")) << text;
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
    EXPECT_NE(text.find(phrase), std::string::npos) << text << "\nexpected: " << phrase;
  }
}

void expect_tetrahedron(const std::filesystem::path& file, double unit = 1.0) {
  SCOPED_TRACE(file.string());
  const LoadedMesh loaded = load_mesh(file);
  EXPECT_EQ(loaded.mesh.vertices.size(), 4u);
  EXPECT_EQ(loaded.mesh.triangles.size(), 4u);
  test::expect_outward_solid(loaded.mesh);
  EXPECT_NEAR(signed_volume(loaded.mesh), unit * unit * unit, 1e-6 * unit * unit * unit);
  EXPECT_TRUE(bounds(loaded.mesh).size().isApprox(unit * Vector3(1, 2, 3), 1e-6));
}

// The bytes of gltf_buffer() as base64.
std::string embedded_gltf() {
  return test::gltf_json(
      "\"uri\":\"data:application/octet-stream;base64,"
      "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAAEAAAAAAAAAAAAAAAAAAAEBA"
      "AAACAAEAAAABAAMAAQACAAMAAAADAAIA\",");
}

// The sample's names, in one part of the size of the tetrahedron.
void expect_one_part(const std::filesystem::path& file, const std::string& name) {
  const std::vector<MeshPart> parts = load_mesh(file).parts;
  ASSERT_EQ(parts.size(), 1U) << file;
  EXPECT_EQ(parts[0].name, name);
  EXPECT_TRUE(parts[0].bounds.size().isApprox(Vector3(1, 2, 3), 1e-6));
}

TEST(MeshParts, AreNamedByMaterialAndPart) {
  expect_one_part(
      written("named.dae", replaced(replaced(test::dae_sample(), "<triangles ",
                                             "<triangles material=\"steel\" "),
                                    "<geometry id=\"g\"", "<geometry id=\"g\" name=\"head\"")),
      "steel head");
  const std::string gltf =
      replaced(replaced(embedded_gltf(), "\"indices\":1", "\"indices\":1,\"material\":0"),
               "{\"mesh\":0,", "{\"mesh\":0,\"name\":\"head\",");
  expect_one_part(
      written("named.gltf",
              replaced(gltf, "\"meshes\":", "\"materials\":[{\"name\":\"steel\"}],\"meshes\":")),
      "steel head");
  const std::filesystem::path obj = written(
      "named.obj",
      "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 3\nf 1 3 2\ng head\nusemtl steel\nf 1 2 4\nf 2 3 4\n"
      "usemtl wood grain\nf 1 4 3\n");
  const std::vector<MeshPart> parts = load_mesh(obj).parts;
  ASSERT_EQ(parts.size(), 3U);
  EXPECT_EQ(parts[0].name, "");
  EXPECT_EQ(parts[1].name, "steel head");
  EXPECT_EQ(parts[2].name, "wood head");
  EXPECT_EQ(parts[0].bounds.size(), Vector3(1, 2, 0));
  EXPECT_EQ(parts[2].bounds.size(), Vector3(0, 2, 3));
}

// So many tell nothing, and must not fill the memory.
TEST(MeshParts, AreNoneWhereThereAreThousands) {
  std::string text = "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 3\n";
  for (int i = 0; i < 3000; ++i) text += "g p" + std::to_string(i) + "\nf 1 3 2\n";
  EXPECT_TRUE(load_mesh(written("many.obj", text)).parts.empty());
}

std::vector<std::pair<std::string, std::string>> samples() {
  return {{"text.obj", test::obj_sample()},       {"text.off", test::off_sample()},
          {"text.ply", test::ply_sample()},       {"text.stl", test::text_stl_sample()},
          {"bin.stl", test::binary_stl_sample()}, {"text.gltf", embedded_gltf()},
          {"bin.glb", test::glb_sample()},        {"text.dae", test::dae_sample()},
          {"text.iv", test::inventor_sample()},   {"text.wrl", test::vrml_sample()}};
}

TEST(LoadMesh, ReadsTheSameBodyFromEveryFormat) {
  for (const auto& [name, bytes] : samples()) expect_tetrahedron(written(name, bytes));
}

TEST(LoadMesh, TellsTheFormatByTheExtensionInAnyCase) {
  expect_tetrahedron(written("shout.OBJ", test::obj_sample()));
  expect_tetrahedron(written("shout.Stl", test::binary_stl_sample()));
}

TEST(LoadMesh, ReadsNamesWithSpacesAndOtherLetters) {
  expect_tetrahedron(written("a t\u00e4sse \u676f.obj", test::obj_sample()));
}

TEST(LoadMesh, ReadsAGltfBufferBesideTheFile) {
  const auto file = written("beside.gltf", test::gltf_json("\"uri\":\"data.bin\","));
  written("data.bin", test::gltf_buffer());
  expect_tetrahedron(file);
  written("data.bin", test::gltf_buffer().substr(0, 20));
  expect_error(file, "buffers: promise 72 bytes, there are 20");
}

TEST(LoadMesh, ReadsAGltfBufferWhoseNameIsEscaped) {
  const auto file = written("blank.gltf", test::gltf_json("\"uri\":\"two%20words.bin\","));
  written("two words.bin", test::gltf_buffer());
  expect_tetrahedron(file);
}

TEST(LoadMesh, ScalesToMetres) {
  const auto file = written("mm.obj", test::obj_sample());
  const LoadedMesh loaded = load_mesh(file, {.metres_per_unit = metres_per_unit("mm")});
  EXPECT_TRUE(bounds(loaded.mesh).size().isApprox(Vector3(0.001, 0.002, 0.003), 1e-12));
}

TEST(LoadMesh, TakesTheUnitOfColladaButNeverTurnsAxes) {
  for (const char* up : {"X_UP", "Y_UP", "Z_UP"}) {
    const std::string turned = replaced(test::dae_sample(), "Z_UP", up);
    expect_tetrahedron(written("up.dae", turned));
    expect_tetrahedron(written("inch.dae", replaced(turned, "meter=\"1\"", "meter=\"0.0254\"")),
                       0.0254);
  }
}

TEST(LoadMesh, AppliesNodeTransformsAndUndoesMirroring) {
  const std::string moved =
      replaced(test::dae_sample(), "<instance_g",
               "<translate>5 0 0</translate><scale>-1 1 1</scale><instance_g");
  const LoadedMesh loaded = load_mesh(written("mirror.dae", moved));
  EXPECT_TRUE(bounds(loaded.mesh).lower.isApprox(Vector3(4, 0, 0)));
  test::expect_outward_solid(loaded.mesh);
}

TEST(LoadMesh, CutsConcavePolygonsAlongTheirInside) {
  const auto file =
      written("dart.obj", "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 1 .5 0\nv 0 2 0\nf 1 2 3 4 5\n");
  const TriangleMesh mesh = load_mesh(file).mesh;
  EXPECT_EQ(mesh.triangles.size(), 3u);
  // A fan about the first corner would count 0.25 twice.
  EXPECT_NEAR(surface_area(mesh), 2.5, 1e-6);
}

TEST(LoadMesh, LeavesOutLinesPointsAndUnusedVertices) {
  const auto file = written("mixed.obj", test::obj_sample() + "v 9 9 9\nl 1 2\np 3\n");
  expect_tetrahedron(file);
}

TEST(LoadMesh, DoesNotOpenWhatAnObjRefersTo) {
  expect_tetrahedron(written("mtl.obj", "mtllib /dev/zero\n" + test::obj_sample()));
}

TEST(LoadMesh, ReadsWhatTheTextFormatsAllow) {
  expect_tetrahedron(
      written("negative.obj", replaced(test::obj_sample(), "f 1 3 2", "f -4 -2 -3")));
  expect_tetrahedron(
      written("slash.obj", replaced(test::obj_sample(), "f 1 3 2", "f 1// 3// 2//")));
  expect_tetrahedron(
      written("more.obj", replaced(test::obj_sample(), "f 1 3 2", "f 1 \\\n3 \\\n2")));
  expect_tetrahedron(
      written("faces_first.obj",
              "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\nv 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 3\n"));
  expect_tetrahedron(
      written("comment.off", replaced(test::off_sample(), "1 0 0\n", "# one\n\n1 0 0 # here\n")));
  expect_tetrahedron(written("short.off", replaced(test::off_sample(), "4 4 0", "4 4")));
  expect_tetrahedron(
      written("color.off", replaced(test::off_sample(), "3 0 2 1", "3 0 2 1 .5 .5 .5")));
  expect_tetrahedron(written("solid.stl", replaced(test::binary_stl_sample(), "     ", "solid")));
  expect_tetrahedron(written("tail.stl", test::binary_stl_sample() + "a signature"));
}

TEST(LoadMesh, RefusesFilesThatAreNone) {
  const auto folder = written("a.obj", "").parent_path();
  expect_error(folder / "missing.obj", "no such file");
  expect_error(folder / "a.obj", "the file is empty");
  std::filesystem::create_directories(folder / "folder.obj");
  expect_error(folder / "folder.obj", "is a folder");
  expect_error(written("scene.3ds", "x"), ".wrl (.3ds)");
  expect_error(written("scene.wrl", "#VRML V2.0 utf8\n"), "no triangles");
  expect_error(written("noextension", "x"), "unknown mesh format");
}

TEST(LoadMesh, RefusesGarbageInEveryFormat) {
  std::string garbage;
  for (unsigned i = 0; i < 3000; ++i) garbage += static_cast<char>((i * 2654435761U) >> 13);
  for (const auto& [name, bytes] : samples()) {
    expect_error(written("garbage" + name.substr(name.find('.')), garbage), ": ");
  }
}

TEST(LoadMesh, NeverTakesATruncatedFileForMore) {
  for (const auto& [name, bytes] : samples()) {
    for (std::size_t size = 1; size < bytes.size(); size += 1 + bytes.size() / 60) {
      const auto file = written(name, bytes.substr(0, size));
      SCOPED_TRACE(file.string() + " cut to " + std::to_string(size));
      try {
        // Text that ends between two faces is a whole file of fewer faces.
        EXPECT_LE(load_mesh(file).mesh.triangles.size(), 4u);
      } catch (const InputError& error) {
        EXPECT_TRUE(std::string(error.what()).starts_with(file.string() + ": "));
      }
    }
  }
}

TEST(LoadMesh, RefusesOptionsOutOfRange) {
  const auto file = written("a.obj", test::obj_sample());
  const InputError unit = test::refusal_of([&] { load_mesh(file, {.metres_per_unit = 0.0}); });
  EXPECT_EQ(unit.file(), file.string());
  EXPECT_EQ(unit.field(), "metres_per_unit");
  EXPECT_EQ(unit.value(), "0.000000");
  EXPECT_THROW(load_mesh(file, {.metres_per_unit = -1.0}), InputError);
  EXPECT_THROW(load_mesh(file, {.weld_fraction = 0.0}), InputError);
  EXPECT_THROW(load_mesh(file, {.weld_fraction = 0.01}), InputError);
}

TEST(LoadMesh, RefusesMeshesOfNoSize) {
  expect_error(written("point.obj", "v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n"), "at one point");
  expect_error(written("line.obj", "v 0 0 0\nv 1 1 1\nv 2 2 2\nf 1 2 3\n"),
               "no triangle has an area");
  expect_error(written("points.obj", "v 0 0 0\nv 1 1 1\n"), "no faces");
  expect_error(written("far.obj", replaced(test::obj_sample(), "v 1", "v 1e32")), "farther out");
}

// Damage to one file: the piece replaced and the phrase of the error that names it.
struct Damage {
  const char* name;
  const char* from;
  const char* to;
  const char* phrase;
};

void expect_errors(const std::string& sample, const std::vector<Damage>& damages) {
  for (const Damage& d : damages) {
    SCOPED_TRACE(std::string(d.from) + " -> " + d.to);
    expect_error(written(d.name, replaced(sample, d.from, d.to)), d.phrase);
  }
}

TEST(LoadMesh, NamesTheLineOfADamagedObj) {
  expect_errors(test::obj_sample(),
                {{"a.obj", "v 1 0", "v nan 0", "line 2: a coordinate"},
                 {"a.obj", "v 1 0", "v inf 0", "line 2: a coordinate"},
                 {"a.obj", "v 1 0", "v 1e300 0", "line 2: a coordinate"},
                 {"a.obj", "v 1 0", "v one 0", "line 2: a coordinate"},
                 {"a.obj", "v 1 0 0", "v 1 0", "line 2: a vertex with fewer"},
                 {"a.obj", "f 1 3 2", "f 1 3 9", "line 5: a face refers to"},
                 {"a.obj", "f 1 3 2", "f 1 3 -9", "line 5: a face refers to"},
                 {"a.obj", "f 1 3 2", "f 1 3 0", "line 5: a face has"},
                 {"a.obj", "f 1 3 2", "f 1 3 x", "line 5: a face has"},
                 {"a.obj", "f 1 3 2", "f 1 3 4294967298", "line 5: a face has"}});
  std::string wide = "f";
  for (int k = 0; k < 10001; ++k) wide += " 1";
  expect_error(written("corners.obj", replaced(test::obj_sample(), "f 1 3 2", wide)),
               "line 5: a face with more than 10000 corners");
  expect_error(written("wide.obj", "\xFE\xFF\n"), "UTF-16");
}

TEST(LoadMesh, NamesTheLineOfADamagedOff) {
  expect_errors(test::off_sample(),
                {{"a.off", "OFF", "COLD", "line 1: not an OFF header"},
                 {"a.off", "OFF", "4OFF", "line 1: only three-dimensional"},
                 {"a.off", "OFF", "OFF BINARY", "line 1: only three-dimensional text"},
                 {"a.off", "4 4 0", "4000000000 4 0", "line 2: promises"},
                 {"a.off", "4 4 0", "4 5 0", "the file ends before face 4 of 5"},
                 {"a.off", "4 4 0", "5 4 0", "the file ends before face 3 of 4"},
                 {"a.off", "4 4 0", "-4 4 0", "line 2: promises"},
                 {"a.off", "1 0 0", "1 nan 0", "line 4: a coordinate"},
                 {"a.off", "3 0 2 1", "3 0 2 4", "line 7: a face refers to vertex 4 of 4"},
                 {"a.off", "3 0 2 1", "3 0 2 -1", "line 7: a face refers to vertex -1 of 4"},
                 {"a.off", "3 0 2 1", "4 0 2 1", "line 7: a vertex of a face is not"},
                 {"a.off", "3 0 2 1", "0", "line 7: a face of 0 corners"}});
}

TEST(LoadMesh, NamesTheDefectOfADamagedPly) {
  expect_errors(test::ply_sample(),
                {{"a.ply", "ply", "plx", "no PLY header"},
                 {"a.ply", "ascii", "morse", "line 2: unknown PLY format 'morse'"},
                 {"a.ply", "vertex 4", "vertex 4000000000", "line 3: promises 4000000000"},
                 {"a.ply", "vertex 4", "vertex -4", "line 3: a PLY element has the count '-4'"},
                 {"a.ply", "float x", "quad x", "line 4: unknown PLY type 'quad'"},
                 {"a.ply", "end_header", "", "does not end"},
                 {"a.ply", "face 4", "face 5", "the file ends inside element 'face'"},
                 {"a.ply", "1 0 0", "1 nan 0", "vertex 1 is not finite"},
                 {"a.ply", "3 0 2 1", "3 0 2 4", "line 14: a face refers to vertex 4 of 4"},
                 {"a.ply", "3 0 2 1", "2000000000 0 2 1", "line 14: a PLY list of length"},
                 {"a.ply", "ascii", "binary_little_endian", ": "},
                 {"a.ply", "ascii", "binary_big_endian", ": "}});
}

TEST(LoadMesh, NamesTheDefectOfADamagedStl) {
  expect_errors(test::text_stl_sample(),
                {{"a.stl", "vertex 0 2 0", "vertex 0 two 0", "line 5: a coordinate"},
                 {"a.stl", "vertex 0 2 0\n", "", "a facet with 2 vertices"},
                 {"a.stl", "endfacet\n", "", "a facet begins inside another"},
                 {"a.stl", "facet normal 0 0 0\n", "", "a vertex outside a facet"}});
  std::string huge = test::binary_stl_sample();
  huge.replace(80, 4, "\xFF\xFF\xFF\xFF");
  expect_error(written("a.stl", huge), "promises 4294967295 triangles, the file has room for 4");
  std::string nan = test::binary_stl_sample();
  nan.replace(84 + 12, 4, std::string("\x00\x00\xC0\x7F", 4));
  expect_error(written("a.stl", nan), "is not finite");
}

TEST(LoadMesh, NamesTheDefectOfADamagedGltf) {
  expect_errors(test::glb_sample(),
                {{"a.glb", "\"2.0\"", "\"1.0\"", "not glTF version 2"},
                 {"a.glb", "\"count\":4", "\"count\":9", "accessors: reach to"},
                 {"a.glb", "5126", "5123", "POSITION: must be three floats"},
                 {"a.glb", "\"SCALAR\"", "\"SCALOR\"", "unknown type"},
                 {"a.glb", "\"mesh\":0", "\"mesh\":7", "mesh: refers to entry 7"},
                 {"a.glb", "\"indices\":1", "\"indices\":2", "indices: refers"},
                 {"a.glb", "[1,1,1]", "[1,\"\",]", "the JSON is not valid"},
                 {"a.glb", "glTF", "glTX", "no GLB header"}});
  expect_error(written("a.gltf", test::gltf_json("\"uri\":\"absent.bin\",")),
               "buffers: no file absent.bin");
  const std::string text = embedded_gltf();
  expect_error(written("a.gltf", replaced(text, "\"mesh\":0", "\"children\":[0]")),
               "contain themselves");
  expect_error(written("a.gltf", replaced(text, "\"mesh\":0", "\"children\":[3]")),
               "children: refers");
  expect_error(written("a.gltf", replaced(text, "\"scene\":0", "\"scene\":5")), "scene: refers");
  expect_error(
      written("a.gltf", replaced(text, "{\"asset\"",
                                 "{\"extensionsRequired\":[\"KHR_draco_mesh_compression\"],"
                                 "\"asset\"")),
      "compressed");
}

TEST(LoadMesh, NamesTheDefectOfADamagedCollada) {
  expect_errors(test::dae_sample(),
                {{"a.dae", "count=\"12\"", "count=\"4000000000\"", "count must be a whole number"},
                 {"a.dae", "count=\"12\"", "", "attribute count is missing"},
                 {"a.dae", "count=\"12\"", "count=\"13\"", "has 12 entries, not 13"},
                 {"a.dae", "count=\"4\" stride", "count=\"5\" stride", "reaches to entry 15 of 12"},
                 {"a.dae", "<p>0 2 1", "<p>0 2 x",
                  "<p>: the content must be a number, at most 1e30 in size (x)"},
                 {"a.dae", "<p>0 2 1", "<p>0 2 -1",
                  "<p>: an entry must be a whole number from 0 to 1e9 (-1)"},
                 {"a.dae", "<p>0 2 1", "<p>0 2 7", "<p>: a face refers to vertex 7 of 4"},
                 {"a.dae", "<p>0 2 1", "<p>0 2", "index count"},
                 {"a.dae", "1 0 0 0 2", "1 0 nan 0 2", "must be a number"},
                 {"a.dae", "meter=\"1\"", "meter=\"0\"", "<unit>: meter must be positive"},
                 {"a.dae", "</node>", "", "a tag is closed that is not open"},
                 {"a.dae", "<instance_geometry url=\"#g\"/>", "<instance_node url=\"#n\"/>",
                  "contains itself"},
                 {"a.dae", "url=\"#g\"", "url=\"#h\"", "there is no geometry (#h)"},
                 {"a.dae", "url=\"#s\"", "url=\"#t\"", "there is no visual_scene (#t)"},
                 {"a.dae", "source=\"#v\"", "source=\"#p\"", "must refer to the vertices"},
                 {"a.dae", "<instance_g", "<skew>30 1 0 0 0 1 0</skew><instance_g",
                  "<skew>: is not supported"}});
  expect_tetrahedron(
      written("comment.dae", replaced(test::dae_sample(), "<p>0 2 1", "<p>0 <!-- -->2 1")));
  std::string doubling;
  for (int i = 0; i < 40; ++i) {
    const std::string next = "<instance_node url=\"#x" + std::to_string(i + 1) + "\"/>";
    doubling += "<node id=\"x" + std::to_string(i) + "\">" + next + next + "</node>";
  }
  doubling += "<node id=\"x40\"/>";
  expect_error(written("bomb.dae", replaced(test::dae_sample(), "<node id", doubling + "<node id")),
               "more than 100000 nodes");
}

TEST(MetresPerUnit, KnowsFourUnits) {
  EXPECT_EQ(metres_per_unit("m"), 1.0);
  EXPECT_EQ(metres_per_unit("cm"), 0.01);
  EXPECT_EQ(metres_per_unit("mm"), 0.001);
  EXPECT_EQ(metres_per_unit("in"), 0.0254);
  EXPECT_THROW(metres_per_unit("ft"), InputError);
  EXPECT_THROW(metres_per_unit(""), InputError);
}

// Surfaces that the readers of a format do not know are refused, where they could be read in part
// or left out without a word.
TEST(MeshFile, UnknownSurfacesAreRefused) {
  const std::string strips =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
      "property float z\nelement tristrips 1\nproperty list int int vertex_indices\nend_header\n"
      "0 0 0\n1 0 0\n0 2 0\n0 0 3\n4 0 1 2 3\n";
  expect_error(written("strips.ply", strips), "surface of element 'tristrips'");
  expect_error(written("no_list.ply", replaced(test::ply_sample(), "vertex_indices", "corners")),
               "list vertex_indices");
  expect_error(
      written("no_z.ply", replaced(test::ply_sample(), "property float z", "property float w")),
      "one x, one y and one z");
  expect_error(written("huge_index.ply", replaced(test::ply_sample(), "3 0 2 1", "3 nan 2 1")),
               "refers to vertex nan");
  expect_error(written("curve.obj", test::obj_sample() + "cstype bezier\ndeg 3 3\n"), "'cstype'");
  expect_error(written("ph.dae", replaced(test::dae_sample(), "<triangles", "<ph></ph><triangles")),
               "<ph>: is not supported");
}

TEST(MeshFile, PointsAndLinesAreNoSurface) {
  expect_tetrahedron(written("lines.obj", test::obj_sample() + "l 1 2\np 3\n"));
  const std::string edges = replaced(test::ply_sample(), "end_header\n",
                                     "element edge 1\nproperty int vertex1\n"
                                     "property int vertex2\nend_header\n");
  expect_tetrahedron(written("edges.ply", edges + "0 1\n"));
}

TEST(MeshFile, DeepGltfIsRefused) {
  const std::string deep =
      "{\"asset\": {\"version\": \"2.0\"}, \"extras\": " + std::string(1'000'000, '[') +
      std::string(1'000'000, ']') + "}";
  expect_error(written("deep.gltf", deep), "nested too deep");
}

}  // namespace
}  // namespace prehend
