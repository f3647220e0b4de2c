#include <algorithm>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "sim/base/input_error.h"
#include "sim/base/json/json_depth.h"
#include "sim/base/number_text.h"
#include "sim/shape/files/gltf_buffers.h"
#include "sim/shape/files/gltf_members.h"
#include "sim/shape/files/mesh_readers.h"
#include "sim/shape/files/text_scan.h"
#include "sim/shape/polygon.h"

// The names and codes are those of the glTF 2.0 specification (Khronos Group, 2021), sections 3.6
// (buffers, views, accessors), 3.7 (meshes) and 3.5 (scenes, nodes).
namespace prehend {
namespace {

using Json = nlohmann::json;

// The modes of a primitive that have a surface. Points and lines are modes 0 to 3.
constexpr std::uint64_t kTriangles = 4;
constexpr std::uint64_t kTriangleStrip = 5;
constexpr std::uint64_t kTriangleFan = 6;
constexpr std::uint64_t kFloat = 5126;
// Vertices and corners of all primitives, and vertices of all nodes. They keep small files whose
// primitives share their data, or whose nodes share their meshes, from expanding to more than the
// memory holds; a mesh of ten million triangles stays below.
constexpr std::uint64_t kMostInPrimitives = 100'000'000;
constexpr std::size_t kMostVertices = 50'000'000;

// Where the bytes of a view lie in GltfBuffers::bytes.
struct View {
  std::uint64_t start = 0;
  std::uint64_t length = 0;
  std::uint64_t stride = 0;  // 0: the elements lie one behind the other
};

// A list of elements: `count` (> 0) times `width` numbers.
struct Accessor {
  std::uint64_t start = 0;  // in GltfBuffers::bytes
  std::uint64_t count = 0;
  std::uint64_t step = 0;       // bytes from one element to the next
  std::uint64_t component = 0;  // code of the type of the numbers
  std::uint64_t width = 0;

  // The numbers of element `i` (width values of the type).
  template <typename Value>
  Value number(const GltfBuffers& buffers, std::uint64_t i, std::uint64_t k = 0) const {
    Value value{};
    std::memcpy(&value, buffers.bytes.data() + start + i * step + k * sizeof(value), sizeof(value));
    return value;
  }
};

struct Node {
  Eigen::Affine3d X_ParentNode = Eigen::Affine3d::Identity();
  std::optional<std::uint64_t> mesh;
  std::vector<std::uint64_t> children;
  std::string name;
};

InputError beyond_end(const char* field, std::uint64_t end, std::uint64_t bytes) {
  return InputError(
      {.field = field,
       .problem = "reach to byte " + std::to_string(end) + " of " + std::to_string(bytes)});
}

// Bytes of one number by its code: signed and unsigned byte, short, and unsigned int and float.
std::uint64_t component_bytes(std::uint64_t code) {
  if (code == 5120 || code == 5121) return 1;
  if (code == 5122 || code == 5123) return 2;
  return code == 5125 || code == kFloat ? 4 : 0;
}

std::uint64_t numbers_of_element(const Json& type) {
  if (type == "SCALAR") return 1;
  if (type == "VEC2") return 2;
  if (type == "VEC3") return 3;
  if (type == "VEC4" || type == "MAT2") return 4;
  if (type == "MAT3") return 9;
  return type == "MAT4" ? 16 : 0;
}

// The name that an object of the document may have.
std::string gltf_name(const Json& object) {
  need_object(object);
  const Json name = object.value("name", Json());
  return name.is_string() ? name.get<std::string>() : std::string();
}

// A part of a colour, `full` at most.
float light_part(const char* field, double value, double full) {
  const std::optional<float> part = color_part(value, full);
  if (!part) {
    throw InputError(
        {.field = field, .problem = "must be from 0 to 1", .value = shortest_text(value)});
  }
  return *part;
}

Eigen::Affine3d transform_of(const Json& node) {
  Eigen::Affine3d X = Eigen::Affine3d::Identity();
  if (node.contains("matrix")) {
    const std::vector<double> columns = gltf_numbers(node, "matrix", 16);
    X.affine() = Eigen::Map<const Eigen::Matrix4d>(columns.data()).topRows<3>();
    return X;
  }
  const auto numbers = [&](const char* name, const std::vector<double>& otherwise) {
    return node.contains(name) ? gltf_numbers(node, name, otherwise.size()) : otherwise;
  };
  const std::vector<double> translation = numbers("translation", {0.0, 0.0, 0.0});
  const std::vector<double> rotation = numbers("rotation", {0.0, 0.0, 0.0, 1.0});
  const std::vector<double> scale = numbers("scale", {1.0, 1.0, 1.0});
  X.translate(Vector3(translation.data()));
  X.rotate(Eigen::Quaterniond(rotation.data()));
  X.scale(Vector3(scale.data()));
  return X;
}

// Reads the parts of the document in the order of their references, buffers first, so that each
// can check its indices against lists that are complete.
class GltfDocument {
 public:
  GltfDocument(const Json& document, const GltfBuffers& buffers, bool colors)
      : document_(document), buffers_(buffers), colors_(colors) {}

  NamedMesh read() {
    const Json asset = document_.value("asset", Json::object());
    const Json version = asset.is_object() ? asset.value("version", Json()) : Json();
    if (!version.is_string() || !version.get<std::string>().starts_with("2")) {
      throw InputError({.problem = "not glTF version 2", .value = version.dump().substr(0, 40)});
    }
    read_views();
    read_accessors();
    read_meshes();
    read_nodes();
    NamedMesh named;
    for (const std::uint64_t root : roots()) {
      add_node(named, nodes_[root], Eigen::Affine3d::Identity());
    }
    return named;
  }

 private:
  // Views must lie within their buffer.
  void read_views() {
    for (const Json& view : gltf_list(document_, "bufferViews")) {
      need_object(view);
      const std::uint64_t buffer = gltf_index(view, "buffer", buffers_.lengths.size());
      const std::uint64_t offset = gltf_count(view, "byteOffset", 0);
      const std::uint64_t length = gltf_count(view, "byteLength", 0);
      if (offset + length > buffers_.lengths[buffer]) {
        throw beyond_end("bufferViews", offset + length, buffers_.lengths[buffer]);
      }
      views_.push_back({.start = buffers_.starts[buffer] + offset,
                        .length = length,
                        .stride = gltf_count(view, "byteStride", 0)});
    }
  }

  // Accessors must lie within their view. The last element needs only its own bytes, not a whole
  // stride.
  Accessor accessor(const Json& given) const {
    need_object(given);
    const std::uint64_t component = gltf_count(given, "componentType", 0);
    const std::uint64_t width = numbers_of_element(given.value("type", Json()));
    const std::uint64_t bytes = component_bytes(component) * width;
    if (bytes == 0) throw InputError({.field = "accessors", .problem = "unknown type"});
    if (given.contains("sparse"))
      throw InputError({.field = "accessors", .problem = "sparse ones cannot be read"});
    if (!given.contains("bufferView"))
      throw InputError({.field = "accessors", .problem = "one has no data (compressed?)"});
    const View& view = views_[gltf_index(given, "bufferView", views_.size())];
    const std::uint64_t offset = gltf_count(given, "byteOffset", 0);
    const std::uint64_t count = gltf_count(given, "count", 0);
    if (count == 0) throw InputError({.field = "accessors", .problem = "one has no elements"});
    const std::uint64_t step = view.stride == 0 ? bytes : view.stride;
    // glTF permits strides up to 252 bytes.
    constexpr std::uint64_t kLargestStride = 252;
    const std::uint64_t end = offset + std::min(step, kLargestStride) * (count - 1) + bytes;
    if (view.stride > kLargestStride || step < bytes || end > view.length) {
      throw beyond_end("accessors", end, view.length);
    }
    return {.start = view.start + offset,
            .count = count,
            .step = step,
            .component = component,
            .width = width};
  }

  void read_accessors() {
    for (const Json& given : gltf_list(document_, "accessors")) {
      accessors_.push_back(accessor(given));
    }
  }

  // Positions of a primitive, which the specification requires to be three floats.
  std::vector<Vector3> positions(const Json& primitive) {
    const Json attributes = primitive.value("attributes", Json::object());
    need_object(attributes);
    const Accessor& given = accessors_[gltf_index(attributes, "POSITION", accessors_.size())];
    if (given.width != 3 || given.component != kFloat) {
      throw InputError({.field = "POSITION", .problem = "must be three floats"});
    }
    count_in(given.count);
    std::vector<Vector3> vertices;
    vertices.reserve(given.count);
    for (std::uint64_t i = 0; i < given.count; ++i) {
      Vector3& p = vertices.emplace_back();
      for (std::uint64_t k = 0; k < 3; ++k) {
        p[static_cast<Eigen::Index>(k)] = given.number<float>(buffers_, i, k);
      }
    }
    return vertices;
  }

  // Corners of a primitive, which the specification requires to be unsigned bytes, shorts or ints,
  // all of them below the number of vertices. Without indices, the vertices in their order.
  std::vector<int> corners(const Json& primitive, std::size_t vertices) {
    std::vector<int> result;
    if (!primitive.contains("indices")) {
      count_in(vertices);
      result.resize(vertices);
      std::iota(result.begin(), result.end(), 0);
      return result;
    }
    const Accessor& given = accessors_[gltf_index(primitive, "indices", accessors_.size())];
    const std::uint64_t type = given.component;
    if (given.width != 1 || (type != 5121 && type != 5123 && type != 5125)) {
      throw InputError({.field = "indices", .problem = "must be unsigned whole numbers"});
    }
    count_in(given.count);
    result.reserve(given.count);
    for (std::uint64_t i = 0; i < given.count; ++i) {
      const std::uint32_t vertex = type == 5121   ? given.number<std::uint8_t>(buffers_, i)
                                   : type == 5123 ? given.number<std::uint16_t>(buffers_, i)
                                                  : given.number<std::uint32_t>(buffers_, i);
      if (vertex >= vertices) {
        throw InputError({.field = "indices",
                          .problem = "refer to vertex " + std::to_string(vertex) + " of " +
                                     std::to_string(vertices)});
      }
      result.push_back(static_cast<int>(vertex));
    }
    return result;
  }

  // The colours of vertices, which the specification requires to be three or four floats, unsigned
  // bytes or shorts; none: the primitive has none.
  std::optional<std::vector<Eigen::Vector3f>> vertex_colors(const Json& primitive,
                                                            std::size_t vertices) const {
    const Json attributes = primitive.value("attributes", Json::object());
    if (!attributes.contains("COLOR_0")) return std::nullopt;
    const Accessor& given = accessors_[gltf_index(attributes, "COLOR_0", accessors_.size())];
    const std::uint64_t type = given.component;
    if ((given.width != 3 && given.width != 4) ||
        (type != kFloat && type != 5121 && type != 5123)) {
      throw InputError(
          {.field = "COLOR_0", .problem = "must be three or four floats or unsigned numbers"});
    }
    if (given.count != vertices) {
      throw InputError({.field = "COLOR_0",
                        .problem = "has " + std::to_string(given.count) + " colours of " +
                                   std::to_string(vertices) + " vertices"});
    }
    std::vector<Eigen::Vector3f> result(vertices);
    for (std::uint64_t i = 0; i < given.count; ++i) {
      for (std::uint64_t k = 0; k < 3; ++k) {
        result[i][static_cast<Eigen::Index>(k)] =
            type == kFloat ? light_part("COLOR_0", given.number<float>(buffers_, i, k), 1.0)
            : type == 5121
                ? light_part("COLOR_0", given.number<std::uint8_t>(buffers_, i, k), 255.0)
                : light_part("COLOR_0", given.number<std::uint16_t>(buffers_, i, k), 65535.0);
      }
    }
    return result;
  }

  // The factor of a primitive's material; none: it has none.
  static SurfaceColor base_color(const Json& primitive, const Json& materials) {
    if (!primitive.contains("material")) return std::nullopt;
    const Json& material = materials[gltf_index(primitive, "material", materials.size())];
    need_object(material);
    const Json surface = material.value("pbrMetallicRoughness", Json::object());
    need_object(surface);
    if (!surface.contains("baseColorFactor")) return std::nullopt;
    const std::vector<double> factor = gltf_numbers(surface, "baseColorFactor", 4);
    Eigen::Vector3f color;
    for (std::size_t k = 0; k < 3; ++k) {
      color[static_cast<Eigen::Index>(k)] = light_part("baseColorFactor", factor[k], 1.0);
    }
    return color;
  }

  // Gives the triangles of the mesh that come from this primitive their colours: products of light.
  void add_colors(const Json& primitive, const Json& materials, std::size_t vertices,
                  NamedMesh& mesh) const {
    const auto of_vertices = vertex_colors(primitive, vertices);
    const SurfaceColor factor = base_color(primitive, materials);
    const auto shown = [](const Eigen::Vector3f& light) {
      return Eigen::Vector3f(shown_part(light[0]), shown_part(light[1]), shown_part(light[2]));
    };
    if (!of_vertices) {
      mesh.color_rest(factor ? SurfaceColor(shown(*factor)) : std::nullopt);
      return;
    }
    std::vector<SurfaceColor> colors;
    colors.reserve(vertices);
    for (const Eigen::Vector3f& light : *of_vertices) {
      colors.emplace_back(shown(factor ? light.cwiseProduct(*factor) : light));
    }
    // The primitive's vertices are the last of the mesh.
    mesh.color_rest_by_vertices(colors, mesh.mesh.vertices.size() - vertices);
  }

  void count_in(std::uint64_t vertices_or_corners) {
    counted_ += vertices_or_corners;
    if (counted_ > kMostInPrimitives) {
      throw InputError({.field = "primitives", .problem = "too many vertices for all of them"});
    }
  }

  TriangleMesh primitive(const Json& given) {
    need_object(given);
    const std::uint64_t mode = gltf_count(given, "mode", kTriangles);
    if (mode > kTriangleFan) throw InputError({.field = "mode", .problem = "unknown"});
    TriangleMesh part{.vertices = positions(given), .triangles = {}};
    const std::vector<int> run = corners(given, part.vertices.size());
    if (mode > kTriangles && run.size() < 3) {
      throw InputError({.field = "primitives", .problem = "a strip or fan of less than 3 corners"});
    }
    if (mode == kTriangleStrip) add_strip(part, run);
    if (mode == kTriangleFan) add_fan(part, run);
    for (std::size_t k = 0; mode == kTriangles && k + 2 < run.size(); k += 3) {
      part.triangles.push_back({run[k], run[k + 1], run[k + 2]});
    }
    return part;
  }

  std::string material_of(const Json& primitive, const Json& materials) const {
    if (!primitive.contains("material")) return {};
    return gltf_name(materials[gltf_index(primitive, "material", materials.size())]);
  }

  void read_meshes() {
    const Json materials = gltf_list(document_, "materials");
    for (const Json& mesh : gltf_list(document_, "meshes")) {
      need_object(mesh);
      NamedMesh& kept = meshes_.emplace_back();
      for (const Json& given : gltf_list(mesh, "primitives")) {
        const TriangleMesh part = primitive(given);
        append(kept.mesh, part);
        kept.name_rest(material_of(given, materials));
        if (colors_) add_colors(given, materials, part.vertices.size(), kept);
      }
    }
  }

  // Every node has at most one parent.
  void read_nodes() {
    const Json given = gltf_list(document_, "nodes");
    parents_.assign(given.size(), -1);
    for (std::size_t i = 0; i < given.size(); ++i) {
      need_object(given[i]);
      Node& node = nodes_.emplace_back();
      node.X_ParentNode = transform_of(given[i]);
      node.name = gltf_name(given[i]);
      if (given[i].contains("mesh")) node.mesh = gltf_index(given[i], "mesh", meshes_.size());
      for (const Json& child : gltf_list(given[i], "children")) {
        const std::uint64_t c = gltf_index({{"children", child}}, "children", given.size());
        if (parents_[c] >= 0)
          throw InputError(
              {.field = "children", .problem = "node " + std::to_string(c) + " has two parents"});
        parents_[c] = static_cast<long>(i);
        node.children.push_back(c);
      }
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

  // The roots of the default scene, or, in a file without scenes, all nodes that have no parent.
  std::vector<std::uint64_t> roots() const {
    const Json scenes = gltf_list(document_, "scenes");
    std::vector<std::uint64_t> result;
    if (scenes.empty()) {
      for (std::size_t i = 0; i < parents_.size(); ++i) {
        if (parents_[i] < 0) result.push_back(i);
      }
      return result;
    }
    const std::uint64_t chosen =
        document_.contains("scene") ? gltf_index(document_, "scene", scenes.size()) : 0;
    need_object(scenes[chosen]);
    std::vector<bool> seen(nodes_.size(), false);
    for (const Json& root : gltf_list(scenes[chosen], "nodes")) {
      const std::uint64_t r = gltf_index({{"nodes", root}}, "nodes", nodes_.size());
      if (seen[r])
        throw InputError(
            {.field = "scenes", .problem = "node " + std::to_string(r) + " is listed twice"});
      seen[r] = true;
      result.push_back(r);
    }
    return result;
  }

  void add_node(NamedMesh& named, const Node& node, const Eigen::Affine3d& X_FileParent) const {
    const Eigen::Affine3d X_FileNode = X_FileParent * node.X_ParentNode;
    if (node.mesh) {
      const NamedMesh& part = meshes_[*node.mesh];
      if (named.mesh.vertices.size() + part.mesh.vertices.size() > kMostVertices) {
        throw InputError({.field = "nodes", .problem = "more than 50 million vertices"});
      }
      append(named.mesh, part.mesh, X_FileNode);
      for (const NamedTriangles& of : part.names) {
        named.add_name(of.name + " " + node.name, of.count);
      }
      named.colors.insert(named.colors.end(), part.colors.begin(), part.colors.end());
    }
    for (const std::uint64_t child : node.children) add_node(named, nodes_[child], X_FileNode);
  }

  const Json& document_;
  const GltfBuffers& buffers_;
  bool colors_;  // whether they are wanted
  std::vector<View> views_;
  std::vector<Accessor> accessors_;
  std::vector<NamedMesh> meshes_;
  std::vector<Node> nodes_;
  std::vector<long> parents_;  // of each node, -1 for none
  std::uint64_t counted_ = 0;  // vertices and corners of all primitives
};

// Parses the JSON text and reads its scene. `chunk`: the binary chunk of the GLB that the text
// comes from.
NamedMesh read_document(std::string_view text, std::string_view chunk,
                        const std::filesystem::path& folder, bool colors) {
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
  return GltfDocument(document, buffers, colors).read();
}

std::uint32_t word_at(std::string_view bytes, std::size_t at) {
  std::uint32_t word = 0;
  std::memcpy(&word, bytes.data() + at, sizeof(word));
  return word;
}

// GLB: a header (magic, version, total length), a JSON chunk and an optional binary chunk. A chunk
// is its length, its type and its data.
constexpr std::size_t kGltfHeader = 12;
constexpr std::size_t kGltfChunkHeader = 8;
constexpr std::uint32_t kJson = 0x4E4F534A;
constexpr std::uint32_t kBinary = 0x004E4942;

}  // namespace

NamedMesh read_gltf(std::string_view bytes, const std::filesystem::path& folder, bool colors) {
  need_text(bytes);
  return read_document(bytes, {}, folder, colors);
}

NamedMesh read_glb(std::string_view bytes, const std::filesystem::path& folder, bool colors) {
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
  return read_document(bytes.substr(kGltfHeader + kGltfChunkHeader, json_bytes), data, folder,
                       colors);
}

}  // namespace prehend
