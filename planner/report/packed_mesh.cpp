#include "planner/report/packed_mesh.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "sim/geometry/weld.h"

namespace prehend {
namespace {

void put(std::uint32_t word, std::vector<std::uint8_t>& bytes) {
  for (int shift = 0; shift < 32; shift += 8) {
    bytes.push_back(static_cast<std::uint8_t>(word >> shift & 0xffU));
  }
}

double area(const TriangleMesh& mesh) {
  double doubled = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    doubled += doubled_area_vector(mesh, t).norm();
  }
  return 0.5 * doubled;
}

TriangleMesh evenly_picked(const TriangleMesh& mesh, std::size_t most) {
  TriangleMesh few{mesh.vertices, {}};
  for (std::size_t i = 0; i < most; ++i) {
    few.triangles.push_back(mesh.triangles[i * mesh.triangles.size() / most]);
  }
  drop_unused_vertices(few);
  return few;
}

}  // namespace

std::string base64(const std::vector<std::uint8_t>& bytes) {
  constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) group = group << 8U | (k < count ? bytes[i + k] : 0U);
    for (std::size_t k = 0; k < 4; ++k) {
      text += k <= count ? kDigits[group >> (18 - 6 * k) & 63U] : '=';
    }
  }
  return text;
}

TriangleMesh simplified(const TriangleMesh& mesh, std::size_t most) {
  if (mesh.triangles.size() <= most) return mesh;
  TriangleMesh coarse = mesh;
  // Vertices that far apart leave somewhat more triangles than that, on any surface. Cells are
  // counted, so there cannot be any number of them in a line.
  double cell = std::max(0.5 * std::sqrt(area(mesh) / static_cast<double>(most)),
                         1e-9 * bounds(mesh).diagonal());
  while (coarse.triangles.size() > most) {
    if (!(cell > 0.0)) return evenly_picked(coarse, most);
    TriangleMesh next = weld(mesh, cell).mesh;
    // Loose pieces that are smaller than what lies between them.
    if (next.triangles.empty()) return evenly_picked(coarse, most);
    coarse = std::move(next);
    const double excess = static_cast<double>(coarse.triangles.size()) / static_cast<double>(most);
    cell *= std::max(1.1, std::sqrt(excess));
  }
  return coarse;
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

}  // namespace prehend
