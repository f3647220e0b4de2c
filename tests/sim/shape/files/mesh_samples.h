// One tetrahedron in every mesh format, as text or bytes, for tests to damage.
#pragma once

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace prehend::test {

// Corners (0,0,0) (1,0,0) (0,2,0) (0,0,3), faces outward: volume 1.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  if (at != std::string::npos) text.replace(at, from.size(), to);
  return text;
}

inline std::string obj_sample() {
  return "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 3\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
}

inline std::string off_sample() {
  return "OFF\n4 4 0\n0 0 0\n1 0 0\n0 2 0\n0 0 3\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
}

inline std::string inventor_sample() {
  return "#Inventor V2.1 ascii\nSeparator { Coordinate3 { point [ 0 0 0, 1 0 0, 0 2 0, 0 0 3 ] }\n"
         "IndexedFaceSet { coordIndex [ 0 2 1 -1 0 1 3 -1 1 2 3 -1 0 3 2 -1 ] } }\n";
}

inline std::string vrml_sample() {
  return "#VRML V2.0 utf8\nShape { geometry IndexedFaceSet {\n"
         "coord Coordinate { point [ 0 0 0, 1 0 0, 0 2 0, 0 0 3 ] }\n"
         "coordIndex [ 0 2 1 -1 0 1 3 -1 1 2 3 -1 0 3 2 -1 ] } }\n";
}

inline std::string ply_sample() {
  return "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
         "property float z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n"
         "0 0 0\n1 0 0\n0 2 0\n0 0 3\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
}

inline std::string text_stl_sample() {
  const char* corner[] = {"vertex 0 0 0\n", "vertex 1 0 0\n", "vertex 0 2 0\n", "vertex 0 0 3\n"};
  const int faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  std::string text = "solid sample\n";
  for (const auto& face : faces) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const int v : face) text += corner[v];
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid sample\n";
}

template <typename Value>
void append_value(std::string& bytes, Value value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

inline const std::vector<std::vector<float>>& sample_points() {
  static const std::vector<std::vector<float>> points{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}};
  return points;
}

inline const std::vector<std::uint16_t>& sample_indices() {
  static const std::vector<std::uint16_t> indices{0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2};
  return indices;
}

inline std::string binary_stl_sample() {
  std::string bytes(80, ' ');
  append_value<std::uint32_t>(bytes, 4);
  for (std::size_t t = 0; t < 4; ++t) {
    for (int k = 0; k < 3; ++k) append_value(bytes, 0.0F);
    for (std::size_t k = 0; k < 3; ++k) {
      for (const float x : sample_points()[sample_indices()[3 * t + k]]) append_value(bytes, x);
    }
    append_value<std::uint16_t>(bytes, 0);
  }
  return bytes;
}

// 48 bytes of points, 24 of indices.
inline std::string gltf_buffer() {
  std::string bytes;
  for (const auto& point : sample_points()) {
    for (const float x : point) append_value(bytes, x);
  }
  for (const std::uint16_t index : sample_indices()) append_value(bytes, index);
  return bytes;
}

// `buffer` is the member that says where the bytes are, if not in the file's chunk.
inline std::string gltf_json(const std::string& buffer) {
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],)"
         R"("nodes":[{"mesh":0,"scale":[1,1,1]}],)"
         R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],)"
         R"("accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},)"
         R"({"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"}],)"
         R"("bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":48},)"
         R"({"buffer":0,"byteOffset":48,"byteLength":24}],"buffers":[{)" +
         buffer + R"("byteLength":72}]})";
}

inline std::string glb_sample() {
  std::string json = gltf_json("");
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const std::string data = gltf_buffer();
  std::string bytes = "glTF";
  append_value<std::uint32_t>(bytes, 2);
  append_value(bytes, static_cast<std::uint32_t>(28 + json.size() + data.size()));
  append_value(bytes, static_cast<std::uint32_t>(json.size()));
  append_value<std::uint32_t>(bytes, 0x4E4F534A);
  bytes += json;
  append_value(bytes, static_cast<std::uint32_t>(data.size()));
  append_value<std::uint32_t>(bytes, 0x004E4942);
  return bytes + data;
}

inline std::string dae_sample() {
  return R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="u" meter="1"/><up_axis>Z_UP</up_axis></asset>
<library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="pa" count="12">0 0 0 1 0 0 0 2 0 0 0 3</float_array>
<technique_common><accessor source="#pa" count="4" stride="3"><param name="X" type="float"/>
<param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="4"><input semantic="VERTEX" source="#v" offset="0"/>
<p>0 2 1 0 1 3 1 2 3 0 3 2</p></triangles></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="n"><instance_geometry url="#g"/></node>
</visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>
)";
}

// A file of the running test, with the bytes given, in its own folder.
inline std::filesystem::path written(const std::string& name, const std::string& bytes) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  std::string folder = std::string(test->test_suite_name()) + "." + test->name();
  for (char& c : folder) c = c == '/' ? '_' : c;
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "prehend" / folder;
  std::filesystem::create_directories(path);
  std::ofstream(path / name, std::ios::binary) << bytes;
  return path / name;
}

}  // namespace prehend::test
