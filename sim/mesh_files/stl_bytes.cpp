// Validation of STL files, text and binary. Nothing in the format tells the two apart for certain.
// Text files begin with the word "solid", but so do the headers of some binary files; a binary file
// has a size that follows from its number of facets. Numbers in binary files are little-endian.
#include <cctype>
#include <cstdint>
#include <cstring>
#include <string>

#include "sim/base/input_error.h"
#include "sim/mesh_files/mesh_bytes.h"
#include "sim/mesh_files/text_scan.h"

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

// Facets must not be nested and must have three vertices with valid coordinates.
void check_text(std::string_view bytes) {
  need_text(bytes);
  TextScan scan(bytes);
  bool in_facet = false;
  int vertices = 0;
  while (scan.next_line()) {
    std::string word(scan.next_word());
    for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (word == "facet") {
      if (in_facet) scan.fail("a facet begins inside another");
      in_facet = true;
      vertices = 0;
    } else if (word == "vertex") {
      if (!in_facet) scan.fail("a vertex outside a facet");
      for (int k = 0; k < 3; ++k) coordinate_in(scan, scan.next_word());
      ++vertices;
    } else if (word == "endfacet") {
      if (!in_facet || vertices < 3) {
        scan.fail("a facet with " + std::to_string(vertices) + " vertices");
      }
      in_facet = false;
    }
  }
  if (in_facet) scan.fail("the file ends inside a facet");
}

// The file must be long enough for its count of facets. Bytes after the last facet are permitted;
// checked_stl removes them.
void check_binary(std::string_view bytes) {
  if (bytes.size() < kHeader) {
    throw InputError("neither text nor binary STL: " + std::to_string(bytes.size()) + " bytes");
  }
  const std::uint64_t room = (bytes.size() - kHeader) / kFacet;
  if (facet_count(bytes) > room) {
    throw InputError("promises " + std::to_string(facet_count(bytes)) +
                     " triangles, the file has room for " + std::to_string(room));
  }
}

}  // namespace

std::string checked_stl(std::string_view bytes) {
  if (is_text(bytes)) {
    check_text(bytes);
    return std::string(bytes);
  }
  check_binary(bytes);
  return std::string(bytes.substr(0, kHeader + kFacet * facet_count(bytes)));
}

}  // namespace prehend
