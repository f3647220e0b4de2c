// Nothing in the format tells text and binary apart for certain. Text files begin with the word
// "solid", but so do the headers of some binary files; a binary file has a size that follows from
// its number of facets. Numbers in binary files are little-endian. Normals are not used.
#include <array>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <string>

#include "sim/base/input_error.h"
#include "sim/shape/files/mesh_readers.h"
#include "sim/shape/files/text_scan.h"

namespace prehend {
namespace {

constexpr std::size_t kHeader = 84;  // 80 bytes of comment, 4 bytes of count
constexpr std::size_t kFacet = 50;   // normal and three vertices as floats, 2 bytes of attribute

// The count behind the comment; the file must be at least kHeader long. 64 bits wide, so that
// products with the size of a facet do not overflow.
std::uint64_t facet_count(std::string_view bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + 80, sizeof(count));
  return count;
}

bool is_text(std::string_view bytes) {
  // The header of a binary file may start with "solid", too. A size that fits the count exactly
  // shows that the file is binary.
  if (bytes.size() >= kHeader && bytes.size() == kHeader + kFacet * facet_count(bytes))
    return false;
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  if (first == bytes.npos) return true;
  std::string word(bytes.substr(first, 5));
  for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return word == "solid";
}

void add_facet(TriangleMesh& mesh, const std::array<Vector3, 3>& corners) {
  const int first = static_cast<int>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), corners.begin(), corners.end());
  mesh.triangles.push_back({first, first + 1, first + 2});
}

Vector3 vertex_in(TextScan& scan) {
  Vector3 vertex;
  for (double& coordinate : vertex) {
    coordinate = static_cast<float>(coordinate_in(scan, scan.next_word()));
  }
  return vertex;
}

// Facets must not be nested and must have three vertices with valid coordinates.
TriangleMesh read_text(std::string_view bytes) {
  need_text(bytes);
  TriangleMesh mesh;
  std::array<Vector3, 3> corners;
  TextScan scan(bytes);
  bool in_facet = false;
  std::size_t vertices = 0;
  while (scan.next_line()) {
    std::string word(scan.next_word());
    for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (word == "facet") {
      if (in_facet) scan.fail("a facet begins inside another");
      in_facet = true;
      vertices = 0;
    } else if (word == "vertex") {
      if (!in_facet) scan.fail("a vertex outside a facet");
      const Vector3 vertex = vertex_in(scan);
      if (vertices < corners.size()) corners[vertices] = vertex;
      ++vertices;
    } else if (word == "endfacet") {
      if (!in_facet || vertices < 3) {
        scan.fail("a facet with " + std::to_string(vertices) + " vertices");
      }
      in_facet = false;
      add_facet(mesh, corners);
    }
  }
  if (in_facet) scan.fail("the file ends inside a facet");
  return mesh;
}

// The file must be long enough for its count of facets. Bytes after the last facet are permitted.
TriangleMesh read_binary(std::string_view bytes) {
  if (bytes.size() < kHeader) {
    throw InputError("neither text nor binary STL: " + std::to_string(bytes.size()) + " bytes");
  }
  const std::uint64_t room = (bytes.size() - kHeader) / kFacet;
  if (facet_count(bytes) > room) {
    throw InputError("promises " + std::to_string(facet_count(bytes)) +
                     " triangles, the file has room for " + std::to_string(room));
  }
  TriangleMesh mesh;
  for (std::uint64_t facet = 0; facet < facet_count(bytes); ++facet) {
    std::array<float, 12> numbers;  // of the normal and the corners
    std::memcpy(numbers.data(), bytes.data() + kHeader + kFacet * facet, sizeof(numbers));
    std::array<Vector3, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = {numbers[3 * k + 3], numbers[3 * k + 4], numbers[3 * k + 5]};
    }
    add_facet(mesh, corners);
  }
  return mesh;
}

}  // namespace

TriangleMesh read_stl(std::string_view bytes) {
  return is_text(bytes) ? read_text(bytes) : read_binary(bytes);
}

}  // namespace prehend
