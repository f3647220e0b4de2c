// Validation of glTF 2 files (JSON text and binary GLB) and their reduction to geometry. A new
// document is built from the checked parts of the old one: buffers, views, accessors, meshes, nodes
// and one scene. Materials, textures, skins, animations, cameras and extensions are not copied, so
// assimp never parses them.
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "sim/base/input_error.h"
#include "sim/json/json_depth.h"
#include "sim/mesh_files/mesh_bytes.h"

namespace prehend {
namespace {

using Json = nlohmann::json;

// The default mode of a primitive. Modes are numbered from 0 (points) to 6 (triangle fan).
constexpr int kTriangles = 4;

// A list of the document; empty when the document has none of that name.
Json list_in(const Json& document, const char* name) {
  const auto found = document.find(name);
  if (found == document.end()) return Json::array();
  if (!found->is_array()) throw InputError({.field = name, .problem = "is not a list"});
  return *found;
}

// A non-negative integer, `otherwise` where it is missing. At most 2^40, so that sums of two of
// them, and products with a valid stride (at most 252), cannot overflow.
std::uint64_t count_in(const Json& object, const char* name, std::uint64_t otherwise) {
  constexpr std::uint64_t kMost = std::uint64_t{1} << 40;
  const auto found = object.find(name);
  if (found == object.end()) return otherwise;
  if (!found->is_number_unsigned() || found->get<std::uint64_t>() > kMost) {
    throw InputError(
        {.field = name, .problem = "is not a count", .value = found->dump().substr(0, 40)});
  }
  return found->get<std::uint64_t>();
}

// A required index into a list of `size` entries.
std::uint64_t index_in(const Json& object, const char* name, std::size_t size) {
  constexpr std::uint64_t kMissing = ~std::uint64_t{0};
  const std::uint64_t index = count_in(object, name, kMissing);
  if (index == kMissing) throw InputError({.field = name, .problem = "is missing"});
  if (index >= size) {
    throw InputError(
        {.field = name,
         .problem = "refers to entry " + std::to_string(index) + " of " + std::to_string(size)});
  }
  return index;
}

InputError beyond_end(const char* field, std::uint64_t end, std::uint64_t bytes) {
  return InputError(
      {.field = field,
       .problem = "reach to byte " + std::to_string(end) + " of " + std::to_string(bytes)});
}

// A copy of the object with the named members only.
Json members(const Json& object, std::initializer_list<const char*> names) {
  if (!object.is_object()) throw InputError("an entry is not an object");
  Json kept = Json::object();
  for (const char* name : names) {
    if (object.contains(name)) kept[name] = object[name];
  }
  return kept;
}

// Member `name`, which must be a list of `size` numbers.
Json numbers(const Json& node, const char* name, std::size_t size) {
  const Json& list = node[name];
  bool fits = list.is_array() && list.size() == size;
  for (std::size_t i = 0; fits && i < size; ++i) fits = list[i].is_number();
  if (!fits)
    throw InputError({.field = name, .problem = "must be " + std::to_string(size) + " numbers"});
  return list;
}

// Builds the reduced document. The functions run in the order of references (buffers first), so
// that each can check its indices against lists that are complete.
class Reducer {
 public:
  Reducer(const Json& document, std::uint64_t chunk_bytes, const std::filesystem::path& folder)
      : document_(document), chunk_bytes_(chunk_bytes), folder_(folder) {}

  Json run() {
    const Json asset = document_.value("asset", Json::object());
    const Json version = asset.is_object() ? asset.value("version", Json()) : Json();
    if (!version.is_string() || !version.get<std::string>().starts_with("2")) {
      throw InputError({.problem = "not glTF version 2", .value = version.dump().substr(0, 40)});
    }
    result_["asset"] = {{"version", "2.0"}};
    buffers();
    views();
    accessors();
    meshes();
    nodes();
    scenes();
    return result_;
  }

 private:
  // Buffers must not be longer than the bytes that are there.
  void buffers() {
    Json& kept = result_["buffers"] = Json::array();
    for (const Json& buffer : list_in(document_, "buffers")) {
      Json entry = members(buffer, {"uri", "byteLength"});
      const std::uint64_t length = count_in(entry, "byteLength", 0);
      const std::uint64_t given = buffer_bytes(entry, kept.empty());
      if (length > given) {
        throw InputError({.field = "buffers",
                          .problem = "promise " + std::to_string(length) + " bytes, there are " +
                                     std::to_string(given)});
      }
      lengths_.push_back(length);
      kept.push_back(std::move(entry));
    }
  }

  // Upper bound of the available bytes of a buffer: the GLB chunk, the length of a data URI (its
  // text is longer than the decoded bytes), or the size of the file. Only the first buffer may be
  // the GLB chunk, which has no uri.
  std::uint64_t buffer_bytes(const Json& buffer, bool first) const {
    if (!buffer.contains("uri")) {
      if (!first) throw InputError({.field = "buffers", .problem = "one has no uri"});
      return chunk_bytes_;
    }
    if (!buffer["uri"].is_string()) throw InputError({.field = "uri", .problem = "is not text"});
    const std::string& uri = buffer["uri"].get_ref<const std::string&>();
    if (uri.starts_with("data:")) return uri.size();
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(folder_ / uri, error);
    if (error) throw InputError({.field = "buffers", .problem = "no file " + uri.substr(0, 200)});
    return size;
  }

  // Views must lie within their buffer.
  void views() {
    Json& kept = result_["bufferViews"] = Json::array();
    for (const Json& view : list_in(document_, "bufferViews")) {
      Json entry = members(view, {"buffer", "byteOffset", "byteLength", "byteStride"});
      const std::uint64_t buffer = index_in(entry, "buffer", lengths_.size());
      const std::uint64_t end = count_in(entry, "byteOffset", 0) + count_in(entry, "byteLength", 0);
      if (end > lengths_[buffer]) {
        throw beyond_end("bufferViews", end, lengths_[buffer]);
      }
      kept.push_back(std::move(entry));
    }
  }

  // Bytes of one element: size of the component (5120 to 5126 are the codes of byte, unsigned byte,
  // short, unsigned short, unsigned int and float) times number of components.
  static std::uint64_t element_bytes(const Json& accessor) {
    const std::uint64_t type = count_in(accessor, "componentType", 0);
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
    for (const Json& accessor : list_in(document_, "accessors")) {
      Json entry =
          members(accessor, {"bufferView", "byteOffset", "componentType", "count", "type"});
      const std::uint64_t bytes = element_bytes(entry);
      if (accessor.contains("sparse"))
        throw InputError({.field = "accessors", .problem = "sparse ones cannot be read"});
      if (!entry.contains("bufferView"))
        throw InputError({.field = "accessors", .problem = "one has no data (compressed?)"});
      const Json& view = views[index_in(entry, "bufferView", views.size())];
      const std::uint64_t stride = count_in(view, "byteStride", 0);
      const std::uint64_t count = count_in(entry, "count", 0);
      if (count == 0) throw InputError({.field = "accessors", .problem = "one has no elements"});
      const std::uint64_t step = stride == 0 ? bytes : stride;
      const std::uint64_t end = count_in(entry, "byteOffset", 0) + step * (count - 1) + bytes;
      // glTF permits strides up to 252 bytes.
      if (stride > 252 || (stride != 0 && stride < bytes) ||
          end > count_in(view, "byteLength", 0)) {
        throw beyond_end("accessors", end, count_in(view, "byteLength", 0));
      }
      kept.push_back(std::move(entry));
    }
  }

  // Keeps positions and indices of a primitive. The specification requires positions of three
  // floats and indices of unsigned bytes, shorts or ints (codes 5121, 5123 and 5125).
  Json primitive(const Json& given) const {
    const Json& accessors = result_["accessors"];
    Json entry = members(given, {"indices", "mode"});
    if (count_in(entry, "mode", kTriangles) > 6)
      throw InputError({.field = "mode", .problem = "unknown"});
    const Json attributes = given.value("attributes", Json::object());
    const Json positions = members(attributes, {"POSITION"});
    const Json& points = accessors[index_in(positions, "POSITION", accessors.size())];
    if (points["type"] != "VEC3" || points["componentType"] != 5126) {
      throw InputError({.field = "POSITION", .problem = "must be three floats"});
    }
    if (entry.contains("indices")) {
      const Json& indices = accessors[index_in(entry, "indices", accessors.size())];
      const std::uint64_t type = indices["componentType"].get<std::uint64_t>();
      if (indices["type"] != "SCALAR" || (type != 5121 && type != 5123 && type != 5125)) {
        throw InputError({.field = "indices", .problem = "must be unsigned whole numbers"});
      }
    }
    // assimp takes memory for "corners - 2" triangles of a strip or fan, also for a negative
    // number.
    const Json& corners =
        entry.contains("indices") ? accessors[entry["indices"].get<std::size_t>()] : points;
    const bool joined = count_in(entry, "mode", kTriangles) > kTriangles;
    if (joined && count_in(corners, "count", 0) < 3) {
      throw InputError({.field = "primitives", .problem = "a strip or fan of less than 3 corners"});
    }
    entry["attributes"] = positions;
    return entry;
  }

  void meshes() {
    Json& kept = result_["meshes"] = Json::array();
    for (const Json& mesh : list_in(document_, "meshes")) {
      Json entry = {{"primitives", Json::array()}};
      for (const Json& given : list_in(mesh, "primitives")) {
        entry["primitives"].push_back(primitive(given));
      }
      kept.push_back(std::move(entry));
    }
  }

  // Keeps mesh, children and transform of the nodes. Every node has at most one parent.
  void nodes() {
    Json& kept = result_["nodes"] = Json::array();
    const Json given = list_in(document_, "nodes");
    parents_.assign(given.size(), -1);
    for (std::size_t i = 0; i < given.size(); ++i) {
      Json entry = members(given[i], {"mesh", "children"});
      if (entry.contains("mesh")) index_in(entry, "mesh", result_["meshes"].size());
      if (given[i].contains("matrix")) entry["matrix"] = numbers(given[i], "matrix", 16);
      if (given[i].contains("translation")) {
        entry["translation"] = numbers(given[i], "translation", 3);
      }
      if (given[i].contains("rotation")) entry["rotation"] = numbers(given[i], "rotation", 4);
      if (given[i].contains("scale")) entry["scale"] = numbers(given[i], "scale", 3);
      for (const Json& child : list_in(entry, "children")) {
        const std::uint64_t c = index_in({{"children", child}}, "children", given.size());
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
    const Json given = list_in(document_, "scenes");
    Json roots = Json::array();
    if (given.empty()) {
      for (std::size_t i = 0; i < parents_.size(); ++i) {
        if (parents_[i] < 0) roots.push_back(i);
      }
    } else {
      const std::uint64_t chosen =
          document_.contains("scene") ? index_in(document_, "scene", given.size()) : 0;
      std::vector<bool> seen(parents_.size(), false);
      for (const Json& root : list_in(given[chosen], "nodes")) {
        const std::uint64_t r = index_in({{"nodes", root}}, "nodes", parents_.size());
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
  std::uint64_t chunk_bytes_;
  std::filesystem::path folder_;
  Json result_ = Json::object();
  std::vector<std::uint64_t> lengths_;
  std::vector<long> parents_;
};

// Parses, checks and reduces the JSON text. `chunk_bytes`: size of the binary chunk of a GLB.
Json reduced(std::string_view text, std::uint64_t chunk_bytes,
             const std::filesystem::path& folder) {
  if (json_depth(text) > kDeepestJson) throw InputError("the JSON is nested too deep");
  const Json document = Json::parse(text, nullptr, false);
  if (document.is_discarded() || !document.is_object()) throw InputError("the JSON is not valid");
  for (const Json& name : list_in(document, "extensionsRequired")) {
    if (name == "KHR_draco_mesh_compression" || name == "EXT_meshopt_compression") {
      throw InputError(
          {.problem = "compressed meshes cannot be read", .value = name.get<std::string>()});
    }
  }
  return Reducer(document, chunk_bytes, folder).run();
}

std::uint32_t word_at(std::string_view bytes, std::size_t at) {
  std::uint32_t word = 0;
  std::memcpy(&word, bytes.data() + at, sizeof(word));
  return word;
}

void append_word(std::string& bytes, std::size_t word) {
  const std::uint32_t narrow = static_cast<std::uint32_t>(word);
  bytes.append(reinterpret_cast<const char*>(&narrow), sizeof(narrow));
}

}  // namespace

std::string checked_gltf(std::string_view bytes, const std::filesystem::path& folder) {
  need_text(bytes);
  return reduced(bytes, 0, folder).dump();
}

// GLB: a header (magic, version, total length), a JSON chunk and an optional binary chunk. A chunk
// is its length, its type and its data. The file is written again around the reduced JSON.
std::string checked_glb(std::string_view bytes, const std::filesystem::path& folder) {
  constexpr std::size_t kHeader = 12;
  constexpr std::size_t kChunkHeader = 8;
  constexpr std::uint32_t kJson = 0x4E4F534A;
  constexpr std::uint32_t kBinary = 0x004E4942;
  if (bytes.size() < kHeader + kChunkHeader || bytes.substr(0, 4) != "glTF") {
    throw InputError("no GLB header");
  }
  if (word_at(bytes, 4) != 2) {
    throw InputError({.problem = "not GLB version 2", .value = std::to_string(word_at(bytes, 4))});
  }
  const std::size_t json_bytes = word_at(bytes, kHeader);
  const std::size_t json_end = kHeader + kChunkHeader + json_bytes;
  if (word_at(bytes, kHeader + 4) != kJson || json_end > bytes.size()) {
    throw InputError("the GLB ends inside its JSON");
  }
  std::string_view data;
  if (bytes.size() >= json_end + kChunkHeader && word_at(bytes, json_end + 4) == kBinary) {
    data = bytes.substr(json_end + kChunkHeader);
    if (word_at(bytes, json_end) > data.size()) throw InputError("the GLB ends inside its data");
    data = data.substr(0, word_at(bytes, json_end));
  }
  std::string json =
      reduced(bytes.substr(kHeader + kChunkHeader, json_bytes), data.size(), folder).dump();
  // Chunks are padded to multiples of 4 bytes, JSON with spaces.
  json.resize((json.size() + 3) / 4 * 4, ' ');
  std::string result = "glTF";
  append_word(result, 2);
  append_word(result, kHeader + 2 * kChunkHeader + json.size() + data.size());
  append_word(result, json.size());
  append_word(result, kJson);
  result += json;
  append_word(result, data.size());
  append_word(result, kBinary);
  result += data;
  return result;
}

}  // namespace prehend
