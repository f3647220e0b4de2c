#include "planner/show/report/packed_mesh.h"

#include <algorithm>
#include <bit>

#include "planner/show/picture/simplified_mesh.h"

namespace prehend {
namespace {

// The lowest byte first, whatever the byte order of this machine: the page reads the bytes as
// little-endian arrays.
void put(std::uint32_t word, std::vector<std::uint8_t>& bytes) {
  for (int shift = 0; shift < 32; shift += 8) {
    bytes.push_back(static_cast<std::uint8_t>(word >> shift & 0xffU));
  }
}

}  // namespace

std::string base64(const std::vector<std::uint8_t>& bytes) {
  constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    // Three bytes become four digits of six bits. A last group of one or two bytes is filled with
    // zeros and gives two or three digits; "=" stands for the others.
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) group = group << 8U | (k < count ? bytes[i + k] : 0U);
    for (std::size_t k = 0; k < 4; ++k) {
      text += k <= count ? kDigits[group >> (18 - 6 * k) & 63U] : '=';
    }
  }
  return text;
}

nlohmann::ordered_json packed_mesh(const TriangleMesh& mesh) {
  std::vector<std::uint8_t> positions;
  std::vector<std::uint8_t> indices;
  positions.reserve(12 * mesh.vertices.size());
  indices.reserve(12 * mesh.triangles.size());
  for (const Vector3& v : mesh.vertices) {
    for (const double x : v) put(std::bit_cast<std::uint32_t>(static_cast<float>(x)), positions);
  }
  for (const Triangle& t : mesh.triangles) {
    for (const int i : t) put(static_cast<std::uint32_t>(i), indices);
  }
  return {{"positions", base64(positions)}, {"indices", base64(indices)}};
}

nlohmann::ordered_json drawn_mesh(const TriangleMesh& mesh, std::size_t most_triangles) {
  const TriangleMesh drawn = simplified(mesh, most_triangles);
  nlohmann::ordered_json json = packed_mesh(drawn);
  if (drawn.triangles.size() < mesh.triangles.size()) {
    json["simplified_from"] = mesh.triangles.size();
  }
  return json;
}

}  // namespace prehend
