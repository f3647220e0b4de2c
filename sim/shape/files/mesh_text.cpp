#include "sim/shape/files/mesh_text.h"

#include <array>
#include <bit>
#include <cctype>
#include <cstdint>
#include <limits>

#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/base/number_text.h"

namespace prehend {
namespace {

static_assert(std::endian::native == std::endian::little, "PLY and STL are written as they are");

void add_vertices(const TriangleMesh& mesh, const char* start, std::string& text) {
  for (const Vector3& p : mesh.vertices) {
    text += start + shortest_text(p.x()) + ' ' + shortest_text(p.y()) + ' ' + shortest_text(p.z());
    text += '\n';
  }
}

template <typename Value>
void add_bytes(const Value& value, std::string& bytes) {
  const auto raw = std::bit_cast<std::array<char, sizeof(Value)>>(value);
  bytes.append(raw.data(), raw.size());
}

void add_single(const Vector3& v, std::string& bytes) {
  for (Eigen::Index k = 0; k < 3; ++k) add_bytes(static_cast<float>(v[k]), bytes);
}

std::string lower_extension(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

}  // namespace

std::string obj_text(const TriangleMesh& mesh) {
  std::string text = "# metres\n";
  add_vertices(mesh, "v ", text);
  for (const Triangle& t : mesh.triangles) {
    text += "f " + std::to_string(t[0] + 1) + " " + std::to_string(t[1] + 1) + " " +
            std::to_string(t[2] + 1) + "\n";
  }
  return text;
}

std::string off_text(const TriangleMesh& mesh) {
  std::string text = "OFF\n" + std::to_string(mesh.vertices.size()) + " " +
                     std::to_string(mesh.triangles.size()) + " 0\n";
  add_vertices(mesh, "", text);
  for (const Triangle& t : mesh.triangles) {
    text += "3 " + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]) +
            "\n";
  }
  return text;
}

std::string ply_bytes(const TriangleMesh& mesh) {
  std::string bytes = "ply\nformat binary_little_endian 1.0\ncomment metres\nelement vertex " +
                      std::to_string(mesh.vertices.size()) +
                      "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
                      std::to_string(mesh.triangles.size()) +
                      "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Vector3& p : mesh.vertices) {
    for (Eigen::Index k = 0; k < 3; ++k) add_bytes(p[k], bytes);
  }
  for (const Triangle& t : mesh.triangles) {
    add_bytes(std::uint8_t{3}, bytes);
    for (const int corner : t) add_bytes(static_cast<std::int32_t>(corner), bytes);
  }
  return bytes;
}

std::string stl_bytes(const TriangleMesh& mesh) {
  constexpr std::size_t kHeader = 80;
  std::string bytes = "binary STL, metres";
  bytes.resize(kHeader, ' ');
  add_bytes(static_cast<std::uint32_t>(mesh.triangles.size()), bytes);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    add_single(doubled_area_vector(mesh, t).stableNormalized(), bytes);
    for (const int corner : mesh.triangles[t]) add_single(mesh.vertices[index(corner)], bytes);
    add_bytes(std::uint16_t{0}, bytes);
  }
  return bytes;
}

bool is_written_mesh_name(const std::filesystem::path& file) {
  const std::string extension = lower_extension(file);
  return extension == ".obj" || extension == ".off" || extension == ".ply" || extension == ".stl";
}

std::string mesh_text(const TriangleMesh& mesh, const std::filesystem::path& file) {
  const std::string extension = lower_extension(file);
  if (extension == ".obj") return obj_text(mesh);
  if (extension == ".off") return off_text(mesh);
  if (extension == ".ply") return ply_bytes(mesh);
  if (extension == ".stl") return stl_bytes(mesh);
  throw InputError({.file = file.string(),
                    .problem = "meshes can be written as .obj .stl .ply .off",
                    .value = file.extension().string()});
}

}  // namespace prehend
