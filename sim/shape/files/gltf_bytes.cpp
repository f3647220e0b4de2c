// Validation of glTF 2 files (JSON text and binary GLB) and their reduction to geometry. A new GLB
// is built from the checked parts of the old document: views, accessors, meshes, nodes, one scene
// and one buffer that holds the data of all. Materials, textures, skins, animations, cameras and
// extensions are not copied, so assimp never parses them, nor any base64 or other file.
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "sim/base/input_error.h"
#include "sim/base/json/json_depth.h"
#include "sim/shape/files/gltf_buffers.h"
#include "sim/shape/files/gltf_members.h"
#include "sim/shape/files/mesh_bytes.h"

namespace prehend {
namespace {

using Json = nlohmann::json;

// The default mode of a primitive. Modes are numbered from 0 (points) to 6 (triangle fan).
constexpr std::uint64_t kTriangles = 4;
// Vertices and corners of all primitives. It keeps small files whose primitives share their data
// from expanding to more than the memory holds; a mesh of ten million triangles stays below.
constexpr std::uint64_t kMostCopied = 100'000'000;

// GLB: a header (magic, version, total length), a JSON chunk and an optional binary chunk. A chunk
// is its length, its type and its data, padded to a multiple of 4 bytes, JSON with spaces.
constexpr std::size_t kGltfHeader = 12;
constexpr std::size_t kGltfChunkHeader = 8;
constexpr std::uint32_t kJson = 0x4E4F534A;
constexpr std::uint32_t kBinary = 0x004E4942;

void append_word(std::string& bytes, std::size_t word) {
  const std::uint32_t narrow = static_cast<std::uint32_t>(word);
  bytes.append(reinterpret_cast<const char*>(&narrow), sizeof(narrow));
}

// `data` is a multiple of 4 bytes.
std::string glb_of(std::string json, const std::string& data) {
  json.resize((json.size() + 3) / 4 * 4, ' ');
  std::string result = "glTF";
  append_word(result, 2);
  append_word(result, kGltfHeader + 2 * kGltfChunkHeader + json.size() + data.size());
  append_word(result, json.size());
  append_word(result, kJson);
  result += json;
  append_word(result, data.size());
  append_word(result, kBinary);
  result += data;
  return result;
}

InputError beyond_end(const char* field, std::uint64_t end, std::uint64_t bytes) {
  return InputError(
      {.field = field,
       .problem = "reach to byte " + std::to_string(end) + " of " + std::to_string(bytes)});
}

// Builds the reduced document. The functions run in the order of references (buffers first), so
// that each can check its indices against lists that are complete.
class Reducer {
 public:
  Reducer(const Json& document, const GltfBuffers& buffers)
      : document_(document), buffers_(buffers) {}

  Json run() {
    const Json asset = document_.value("asset", Json::object());
    const Json version = asset.is_object() ? asset.value("version", Json()) : Json();
    if (!version.is_string() || !version.get<std::string>().starts_with("2")) {
      throw InputError({.problem = "not glTF version 2", .value = version.dump().substr(0, 40)});
    }
    result_["asset"] = {{"version", "2.0"}};
    result_["buffers"] = Json::array({{{"byteLength", buffers_.bytes.size()}}});
    views();
    accessors();
    meshes();
    nodes();
    scenes();
    return result_;
  }

 private:
  // Views must lie within their buffer.
  void views() {
    Json& kept = result_["bufferViews"] = Json::array();
    for (const Json& view : gltf_list(document_, "bufferViews")) {
      Json entry = gltf_members(view, {"buffer", "byteOffset", "byteLength", "byteStride"});
      const std::uint64_t buffer = gltf_index(entry, "buffer", buffers_.lengths.size());
      const std::uint64_t offset = gltf_count(entry, "byteOffset", 0);
      const std::uint64_t end = offset + gltf_count(entry, "byteLength", 0);
      if (end > buffers_.lengths[buffer]) {
        throw beyond_end("bufferViews", end, buffers_.lengths[buffer]);
      }
      entry["buffer"] = 0;
      entry["byteOffset"] = buffers_.starts[buffer] + offset;
      kept.push_back(std::move(entry));
    }
  }

  // Bytes of one element: size of the component (5120 to 5126 are the codes of byte, unsigned byte,
  // short, unsigned short, unsigned int and float) times number of components.
  static std::uint64_t element_bytes(const Json& accessor) {
    const std::uint64_t type = gltf_count(accessor, "componentType", 0);
    const std::uint64_t size = type == 5120 || type == 5121   ? 1
                               : type == 5122 || type == 5123 ? 2
                               : type == 5125 || type == 5126 ? 4
                                                              : 0;
    const Json name = accessor.value("type", Json());
    const std::uint64_t width = name == "SCALAR"                   ? 1
                                : name == "VEC2"                   ? 2
                                : name == "VEC3"                   ? 3
                                : name == "VEC4" || name == "MAT2" ? 4
                                : name == "MAT3"                   ? 9
                                : name == "MAT4"                   ? 16
                                                                   : 0;
    if (size * width == 0) throw InputError({.field = "accessors", .problem = "unknown type"});
    return size * width;
  }

  // Accessors must lie within their view. The last element needs only its own bytes, not a whole
  // stride.
  void accessors() {
    Json& kept = result_["accessors"] = Json::array();
    const Json& views = result_["bufferViews"];
    for (const Json& accessor : gltf_list(document_, "accessors")) {
      Json entry =
          gltf_members(accessor, {"bufferView", "byteOffset", "componentType", "count", "type"});
      const std::uint64_t bytes = element_bytes(entry);
      if (accessor.contains("sparse"))
        throw InputError({.field = "accessors", .problem = "sparse ones cannot be read"});
      if (!entry.contains("bufferView"))
        throw InputError({.field = "accessors", .problem = "one has no data (compressed?)"});
      const Json& view = views[gltf_index(entry, "bufferView", views.size())];
      const std::uint64_t stride = gltf_count(view, "byteStride", 0);
      const std::uint64_t count = gltf_count(entry, "count", 0);
      if (count == 0) throw InputError({.field = "accessors", .problem = "one has no elements"});
      const std::uint64_t step = stride == 0 ? bytes : stride;
      const std::uint64_t end = gltf_count(entry, "byteOffset", 0) + step * (count - 1) + bytes;
      // glTF permits strides up to 252 bytes.
      if (stride > 252 || (stride != 0 && stride < bytes) ||
          end > gltf_count(view, "byteLength", 0)) {
        throw beyond_end("accessors", end, gltf_count(view, "byteLength", 0));
      }
      kept.push_back(std::move(entry));
    }
  }

  // The accessor of the positions of a primitive, which the specification requires to be three
  // floats.
  const Json& positions_of(const Json& attributes) const {
    const Json& accessors = result_["accessors"];
    const Json& positions = accessors[gltf_index(attributes, "POSITION", accessors.size())];
    if (positions["type"] != "VEC3" || positions["componentType"] != 5126) {
      throw InputError({.field = "POSITION", .problem = "must be three floats"});
    }
    return positions;
  }

  // The accessor of the indices of a primitive, which the specification requires to be unsigned
  // bytes, shorts or ints (codes 5121, 5123 and 5125), all of them below the number of vertices.
  const Json& indices_of(const Json& entry, std::uint64_t vertices) {
    const Json& accessors = result_["accessors"];
    const std::uint64_t chosen = gltf_index(entry, "indices", accessors.size());
    const Json& indices = accessors[chosen];
    const std::uint64_t type = indices["componentType"].get<std::uint64_t>();
    if (indices["type"] != "SCALAR" || (type != 5121 && type != 5123 && type != 5125)) {
      throw InputError({.field = "indices", .problem = "must be unsigned whole numbers"});
    }
    std::optional<std::uint32_t>& largest = largest_index_[chosen];
    if (!largest) largest = largest_of(indices);
    if (*largest >= vertices) {
      throw InputError({.field = "indices",
                        .problem = "refer to vertex " + std::to_string(*largest) + " of " +
                                   std::to_string(vertices)});
    }
    return indices;
  }

  // The largest value of an accessor of unsigned integers (stored with the low byte first).
  std::uint32_t largest_of(const Json& indices) const {
    const Json& view = result_["bufferViews"][indices["bufferView"].get<std::size_t>()];
    const std::size_t bytes = element_bytes(indices);
    const std::size_t stride = gltf_count(view, "byteStride", 0);
    const std::size_t start =
        gltf_count(view, "byteOffset", 0) + gltf_count(indices, "byteOffset", 0);
    const std::size_t count = gltf_count(indices, "count", 0);
    std::uint32_t largest = 0;
    for (std::size_t i = 0; i < count; ++i) {
      std::uint32_t value = 0;
      std::memcpy(&value, buffers_.bytes.data() + start + i * (stride == 0 ? bytes : stride),
                  bytes);
      largest = std::max(largest, value);
    }
    return largest;
  }

  // Keeps positions and indices of a primitive.
  Json primitive(const Json& given) {
    Json entry = gltf_members(given, {"indices", "mode"});
    const std::uint64_t mode = gltf_count(entry, "mode", kTriangles);
    if (mode > 6) throw InputError({.field = "mode", .problem = "unknown"});
    entry["attributes"] = gltf_members(given.value("attributes", Json::object()), {"POSITION"});
    const std::uint64_t vertices = gltf_count(positions_of(entry["attributes"]), "count", 0);
    const std::uint64_t corners =
        entry.contains("indices") ? gltf_count(indices_of(entry, vertices), "count", 0) : vertices;
    // assimp takes memory for "corners - 2" triangles of a strip or fan, also for a negative
    // number.
    if (mode > kTriangles && corners < 3) {
      throw InputError({.field = "primitives", .problem = "a strip or fan of less than 3 corners"});
    }
    // assimp copies the data for each primitive that refers to it.
    copied_ += vertices + corners;
    if (copied_ > kMostCopied) {
      throw InputError({.field = "primitives", .problem = "too many vertices for all of them"});
    }
    return entry;
  }

  void meshes() {
    Json& kept = result_["meshes"] = Json::array();
    for (const Json& mesh : gltf_list(document_, "meshes")) {
      Json entry = {{"primitives", Json::array()}};
      for (const Json& given : gltf_list(mesh, "primitives")) {
        entry["primitives"].push_back(primitive(given));
      }
      kept.push_back(std::move(entry));
    }
  }

  // Keeps mesh, children and transform of the nodes. Every node has at most one parent.
  void nodes() {
    Json& kept = result_["nodes"] = Json::array();
    const Json given = gltf_list(document_, "nodes");
    parents_.assign(given.size(), -1);
    for (std::size_t i = 0; i < given.size(); ++i) {
      Json entry = gltf_members(given[i], {"mesh", "children"});
      if (entry.contains("mesh")) gltf_index(entry, "mesh", result_["meshes"].size());
      if (given[i].contains("matrix")) entry["matrix"] = gltf_numbers(given[i], "matrix", 16);
      if (given[i].contains("translation")) {
        entry["translation"] = gltf_numbers(given[i], "translation", 3);
      }
      if (given[i].contains("rotation")) entry["rotation"] = gltf_numbers(given[i], "rotation", 4);
      if (given[i].contains("scale")) entry["scale"] = gltf_numbers(given[i], "scale", 3);
      for (const Json& child : gltf_list(entry, "children")) {
        const std::uint64_t c = gltf_index({{"children", child}}, "children", given.size());
        if (parents_[c] >= 0)
          throw InputError(
              {.field = "children", .problem = "node " + std::to_string(c) + " has two parents"});
        parents_[c] = static_cast<long>(i);
      }
      kept.push_back(std::move(entry));
    }
    need_shallow_trees();
  }

  // Rejects cycles and deep nesting. As every node has at most one parent, following the parents
  // ends at a root, unless there is a cycle.
  void need_shallow_trees() const {
    constexpr int kDeepest = 200;
    for (std::size_t i = 0; i < parents_.size(); ++i) {
      int depth = 0;
      for (long at = static_cast<long>(i); at >= 0; at = parents_[static_cast<std::size_t>(at)]) {
        if (++depth > kDeepest)
          throw InputError(
              {.field = "children", .problem = "nodes contain themselves or nest too deep"});
      }
    }
  }

  // Makes one scene with the roots of the default scene, or, in a file without scenes, with all
  // nodes that have no parent.
  void scenes() {
    const Json given = gltf_list(document_, "scenes");
    Json roots = Json::array();
    if (given.empty()) {
      for (std::size_t i = 0; i < parents_.size(); ++i) {
        if (parents_[i] < 0) roots.push_back(i);
      }
    } else {
      const std::uint64_t chosen =
          document_.contains("scene") ? gltf_index(document_, "scene", given.size()) : 0;
      std::vector<bool> seen(parents_.size(), false);
      for (const Json& root : gltf_list(given[chosen], "nodes")) {
        const std::uint64_t r = gltf_index({{"nodes", root}}, "nodes", parents_.size());
        if (seen[r])
          throw InputError(
              {.field = "scenes", .problem = "node " + std::to_string(r) + " is listed twice"});
        seen[r] = true;
        roots.push_back(r);
      }
    }
    result_["scene"] = 0;
    result_["scenes"] = Json::array({{{"nodes", roots}}});
  }

  const Json& document_;
  const GltfBuffers& buffers_;
  Json result_ = Json::object();
  std::vector<long> parents_;
  // By accessor, where it was used as indices.
  std::map<std::uint64_t, std::optional<std::uint32_t>> largest_index_;
  std::uint64_t copied_ = 0;
};

// Parses and checks the JSON text, and writes the GLB of its geometry. `chunk`: the binary chunk of
// the GLB that the text comes from.
std::string reduced(std::string_view text, std::string_view chunk,
                    const std::filesystem::path& folder) {
  if (json_depth(text) > kDeepestJson) throw InputError("the JSON is nested too deep");
  const Json document = Json::parse(text, nullptr, false);
  if (document.is_discarded() || !document.is_object()) throw InputError("the JSON is not valid");
  for (const Json& name : gltf_list(document, "extensionsRequired")) {
    if (name == "KHR_draco_mesh_compression" || name == "EXT_meshopt_compression") {
      throw InputError(
          {.problem = "compressed meshes cannot be read", .value = name.get<std::string>()});
    }
  }
  const GltfBuffers buffers = fetch_gltf_buffers(gltf_list(document, "buffers"), chunk, folder);
  return glb_of(Reducer(document, buffers).run().dump(), buffers.bytes);
}

std::uint32_t word_at(std::string_view bytes, std::size_t at) {
  std::uint32_t word = 0;
  std::memcpy(&word, bytes.data() + at, sizeof(word));
  return word;
}

}  // namespace

std::string checked_gltf(std::string_view bytes, const std::filesystem::path& folder) {
  need_text(bytes);
  return reduced(bytes, {}, folder);
}

std::string checked_glb(std::string_view bytes, const std::filesystem::path& folder) {
  if (bytes.size() < kGltfHeader + kGltfChunkHeader || bytes.substr(0, 4) != "glTF") {
    throw InputError("no GLB header");
  }
  if (word_at(bytes, 4) != 2) {
    throw InputError({.problem = "not GLB version 2", .value = std::to_string(word_at(bytes, 4))});
  }
  const std::size_t json_bytes = word_at(bytes, kGltfHeader);
  const std::size_t json_end = kGltfHeader + kGltfChunkHeader + json_bytes;
  if (word_at(bytes, kGltfHeader + 4) != kJson || json_end > bytes.size()) {
    throw InputError("the GLB ends inside its JSON");
  }
  std::string_view data;
  if (bytes.size() >= json_end + kGltfChunkHeader && word_at(bytes, json_end + 4) == kBinary) {
    data = bytes.substr(json_end + kGltfChunkHeader);
    if (word_at(bytes, json_end) > data.size()) throw InputError("the GLB ends inside its data");
    data = data.substr(0, word_at(bytes, json_end));
  }
  return reduced(bytes.substr(kGltfHeader + kGltfChunkHeader, json_bytes), data, folder);
}

}  // namespace prehend
