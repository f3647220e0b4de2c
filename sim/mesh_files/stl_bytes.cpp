// Checks of STL files, text and binary.
#include <cctype>
#include <cstdint>
#include <cstring>
#include <string>

#include "sim/base/input_error.h"
#include "sim/mesh_files/mesh_bytes.h"
#include "sim/mesh_files/text_scan.h"

namespace prehend {
namespace {

constexpr std::size_t kHeader = 84;  // 80 bytes of comment, 4 of the count
constexpr std::size_t kFacet = 50;

std::uint64_t facet_count(std::string_view bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + 80, sizeof(count));
  return count;
}

bool is_text(std::string_view bytes) {
  // Binary files, too, may start with "solid"; their size gives them away.
  if (bytes.size() >= kHeader && bytes.size() == kHeader + kFacet * facet_count(bytes))
    return false;
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  if (first == bytes.npos) return true;
  std::string word(bytes.substr(first, 5));
  for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return word == "solid";
}

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
