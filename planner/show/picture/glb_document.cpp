// A .glb file is a JSON document and a binary buffer in one. The document lists nodes (a pose
// each), meshes, materials, and accessors (typed arrays) that refer by way of buffer views to byte
// ranges of the buffer. Section numbers below are those of the glTF 2.0 specification (Khronos
// Group, version 2.0.1).
#include "planner/show/picture/glb_document.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <numbers>

#include "sim/base/input_error.h"
#include "sim/base/pose.h"

namespace prehend {
namespace {

using Json = GlbDocument::Json;

static_assert(std::endian::native == std::endian::little, "glTF's buffers are little-endian");

// Component types of accessors (3.6.2.2) and targets of buffer views (5.11), numbered as in OpenGL.
constexpr int kUnsignedShort = 5123;
constexpr int kUnsignedInt = 5125;
constexpr int kFloat = 5126;
constexpr int kVertexData = 34962;
constexpr int kIndexData = 34963;

// Roughness of the material: a matt surface with a faint highlight.
constexpr double kRoughness = 0.7;

// Chunks must start at multiples of four bytes (4.4.3), accessors at multiples of the size of their
// components (3.6.2.4), which is at most four. The padding is blanks after JSON and zeros after
// data.
void pad(std::string& bytes, char with) { bytes.resize((bytes.size() + 3) / 4 * 4, with); }

template <typename Element>
void append_raw(std::string& bytes, const std::vector<Element>& elements) {
  bytes.append(reinterpret_cast<const char*>(elements.data()), elements.size() * sizeof(Element));
}

// A unit quaternion in glTF's order.
Json rotation_json(const Eigen::Quaterniond& q) { return {q.x(), q.y(), q.z(), q.w()}; }

Json corner_json(const std::array<float, 3>& corner) {
  return {static_cast<double>(corner[0]), static_cast<double>(corner[1]),
          static_cast<double>(corner[2])};
}

// Header, a chunk of JSON, a chunk of data where there is any (4.4).
std::string glb_file(std::string json, const std::string& data) {
  // Chunk types: the bytes "JSON" and "BIN\0" as little-endian numbers.
  constexpr std::uint32_t kJson = 0x4E4F534A;
  constexpr std::uint32_t kBinary = 0x004E4942;
  constexpr std::size_t kHeader = 12;
  constexpr std::size_t kChunkHeader = 8;
  pad(json, ' ');
  std::size_t total = kHeader + kChunkHeader + json.size();
  if (!data.empty()) total += kChunkHeader + data.size();
  if (total > std::numeric_limits<std::uint32_t>::max()) {
    throw InputError(
        {.problem = "glTF: more than 4 GiB", .value = std::to_string(total) + " bytes"});
  }
  const auto word = [](std::size_t size) { return static_cast<std::uint32_t>(size); };
  std::string file = "glTF";
  file.reserve(total);
  // Version 2 and the length of the file, then the length and type of the chunk.
  append_raw<std::uint32_t>(file, {2, word(total), word(json.size()), kJson});
  file += json;
  if (data.empty()) return file;
  append_raw<std::uint32_t>(file, {word(data.size()), kBinary});
  return file += data;
}

}  // namespace

template <typename Element>
std::size_t GlbDocument::accessor_of(const std::vector<Element>& elements, int target,
                                     Json accessor) {
  const std::size_t start = buffer_.size();
  append_raw(buffer_, elements);
  Json view = {{"buffer", 0}, {"byteOffset", start}, {"byteLength", buffer_.size() - start}};
  if (target != 0) view["target"] = target;
  views_.push_back(std::move(view));
  // Padding between accessors is not part of a view, whose length is set above.
  pad(buffer_, '\0');
  accessor["bufferView"] = views_.size() - 1;
  accessors_.push_back(std::move(accessor));
  return accessors_.size() - 1;
}

// The arrays of a mesh as accessors. The format demands bounds (min, max) of positions (3.6.2.5);
// indices are 16-bit where that is enough, which halves their size.
GlbDocument::Json GlbDocument::primitive_of(const VertexArrays& arrays) {
  std::array<float, 3> lower = arrays.positions.front();
  std::array<float, 3> upper = lower;
  for (const std::array<float, 3>& p : arrays.positions) {
    for (std::size_t k = 0; k < 3; ++k) {
      lower[k] = std::min(lower[k], p[k]);
      upper[k] = std::max(upper[k], p[k]);
    }
  }
  Json primitive;
  const std::size_t vertices = arrays.positions.size();
  Json vectors = {{"componentType", kFloat}, {"count", vertices}, {"type", "VEC3"}};
  primitive["attributes"]["NORMAL"] = accessor_of(arrays.normals, kVertexData, vectors);
  vectors["min"] = corner_json(lower);
  vectors["max"] = corner_json(upper);
  primitive["attributes"]["POSITION"] = accessor_of(arrays.positions, kVertexData, vectors);

  // The largest value of an index type must not occur as an index (3.7.2.1), because it restarts
  // strips. With 65535 vertices the largest index is 65534.
  const bool small = vertices <= std::numeric_limits<std::uint16_t>::max();
  const Json indices = {{"componentType", small ? kUnsignedShort : kUnsignedInt},
                        {"count", 3 * arrays.triangles.size()},
                        {"type", "SCALAR"}};
  if (small) {
    std::vector<std::uint16_t> narrow;
    for (const auto& triangle : arrays.triangles) {
      for (const std::uint32_t v : triangle) narrow.push_back(static_cast<std::uint16_t>(v));
    }
    primitive["indices"] = accessor_of(narrow, kIndexData, indices);
  } else {
    primitive["indices"] = accessor_of(arrays.triangles, kIndexData, indices);
  }
  return primitive;
}

// Index of the geometry of a mesh, which is stored once however many bodies have it. Meshes are the
// same if they are the same object or have equal contents. -1 for a mesh without a triangle that
// has area: the format has no empty meshes.
int GlbDocument::geometry_of(const SharedMesh& mesh) {
  auto known = std::find_if(geometries_.begin(), geometries_.end(), [&](const Geometry& other) {
    return &*other.mesh == &*mesh ||
           (other.mesh->triangles == mesh->triangles && other.mesh->vertices == mesh->vertices);
  });
  if (known == geometries_.end()) {
    const VertexArrays arrays = vertex_arrays(*mesh, crease_angle_);
    geometries_.push_back({mesh, arrays.triangles.empty() ? Json() : primitive_of(arrays)});
    known = geometries_.end() - 1;
  }
  return known->primitive.is_null() ? -1 : static_cast<int>(known - geometries_.begin());
}

// Index of the glTF mesh with this geometry and material. In glTF the material belongs to the mesh,
// so a geometry in two colours needs two meshes, which share their accessors.
int GlbDocument::coloured(int geometry, int material) {
  const auto next = static_cast<int>(meshes_.size());
  const auto [known, is_new] = mesh_numbers_.try_emplace({geometry, material}, next);
  if (is_new) {
    Json primitive = geometries_[static_cast<std::size_t>(geometry)].primitive;
    primitive["material"] = material;
    meshes_.push_back({{"primitives", Json::array({primitive})}});
  }
  return known->second;
}

// Index of the material of a color, stored once. Base colors are linear light, not sRGB (3.9.2).
int GlbDocument::material_of(const Color& color) {
  const Light light = light_of(color);
  const double opacity = color.opacity > 0.0 ? std::min(color.opacity, 1.0) : 0.0;
  Json material;
  material["pbrMetallicRoughness"] = {{"baseColorFactor", {light[0], light[1], light[2], opacity}},
                                      {"metallicFactor", 0.0},
                                      {"roughnessFactor", kRoughness}};
  // Without this readers take the material for opaque and ignore the fourth component.
  if (opacity < 1.0) material["alphaMode"] = "BLEND";
  material["doubleSided"] = true;
  const auto known = std::find(materials_.begin(), materials_.end(), material);
  const auto number = static_cast<int>(known - materials_.begin());
  if (known == materials_.end()) materials_.push_back(std::move(material));
  return number;
}

GlbDocument::Json GlbDocument::placed(const std::string& name, const Pose& X) {
  if (!X.matrix().allFinite()) throw InputError({.field = "X_WB", .problem = "must be finite"});
  const Vector3& p = X.translation();
  return {{"name", name},
          {"translation", {p.x(), p.y(), p.z()}},
          {"rotation", rotation_json(quaternion_of(X).normalized())}};
}

int GlbDocument::mesh_of(const SharedMesh& mesh, const Color& color) {
  const int geometry = geometry_of(mesh);
  return geometry < 0 ? -1 : coloured(geometry, material_of(color));
}

GlbIndex GlbDocument::add_node(Json node) {
  nodes_.push_back(std::move(node));
  is_child_.push_back(false);
  return nodes_.size() - 1;
}

void GlbDocument::put_below(GlbIndex parent, GlbIndex child) {
  nodes_[parent]["children"].push_back(child);
  is_child_[child] = true;
}

// The times of keys need bounds (5.3).
GlbIndex GlbDocument::add_keys(const std::vector<float>& numbers, std::size_t size) {
  const std::array<const char*, 5> types = {"", "SCALAR", "", "VEC3", "VEC4"};
  Json accessor = {
      {"componentType", kFloat}, {"count", numbers.size() / size}, {"type", types[size]}};
  if (size == 1) {
    accessor["min"] = Json::array({static_cast<double>(numbers.front())});
    accessor["max"] = Json::array({static_cast<double>(numbers.back())});
  }
  return accessor_of(numbers, 0, std::move(accessor));
}

void GlbDocument::set_animation(const std::string& name, Json samplers, Json channels) {
  if (channels.empty()) return;  // an empty list is not allowed
  animation_ = {
      {"name", name}, {"samplers", std::move(samplers)}, {"channels", std::move(channels)}};
}

// The root comes last, when its children are known.
std::string GlbDocument::bytes(const std::string& name, const Json& extras) const {
  Json document;
  document["asset"] = {{"version", "2.0"}, {"generator", "prehend"}};
  document["scene"] = 0;
  document["scenes"] = Json::array({{{"nodes", Json::array({nodes_.size()})}}});
  // Turns the world's z axis to glTF's y axis.
  const Eigen::Quaterniond y_up(Eigen::AngleAxisd(-0.5 * std::numbers::pi, Vector3::UnitX()));
  Json root = {{"name", name}, {"rotation", rotation_json(y_up.normalized())}};
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    if (!is_child_[n]) root["children"].push_back(n);
  }
  if (!extras.empty()) root["extras"] = extras;
  document["nodes"] = nodes_;
  document["nodes"].push_back(std::move(root));
  // Empty lists are not allowed either.
  const auto list = [&](const char* key, const Json& entries) {
    if (!entries.empty()) document[key] = entries;
  };
  if (!animation_.is_null()) document["animations"] = Json::array({animation_});
  list("meshes", meshes_);
  list("materials", materials_);
  list("accessors", accessors_);
  list("bufferViews", views_);
  if (!buffer_.empty()) document["buffers"] = Json::array({{{"byteLength", buffer_.size()}}});
  // Names may have bytes that are not UTF-8, for which dump() would throw otherwise.
  return glb_file(document.dump(-1, ' ', false, Json::error_handler_t::replace), buffer_);
}

}  // namespace prehend
