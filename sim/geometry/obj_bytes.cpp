// Checks of Wavefront OBJ files.
#include <algorithm>
#include <optional>
#include <string>

#include "sim/geometry/input_error.h"
#include "sim/geometry/mesh_bytes.h"
#include "sim/geometry/text_scan.h"

namespace prehend {
namespace {

// The next word of a statement, which a backslash at the end of a line continues.
std::string_view next_word(TextScan& scan) {
  std::string_view word = scan.next_word();
  while (word == "\\" && scan.next_line()) word = scan.next_word();
  return word;
}

// Checks one face; returns the highest vertex number it refers to.
long long check_face(TextScan& scan, long long vertices) {
  long long highest = 0;
  for (auto word = next_word(scan); !word.empty(); word = next_word(scan)) {
    if (word.front() == '#') break;
    const std::optional<long long> index = integer_in(word.substr(0, word.find('/')));
    if (!index || *index == 0) scan.fail("a face has the vertex " + quoted(word));
    if (*index < -vertices) {
      scan.fail("a face refers to vertex " + std::to_string(*index) + " of " +
                std::to_string(vertices));
    }
    highest = std::max(highest, *index);
  }
  return highest;
}

}  // namespace

void check_obj(std::string_view bytes) {
  need_text(bytes);
  TextScan scan(bytes);
  long long vertices = 0;
  long long highest = 0;
  int highest_line = 0;
  while (scan.next_line()) {
    const std::string_view statement = scan.next_word();
    if (statement == "v") {
      for (int k = 0; k < 3; ++k) coordinate_in(scan, next_word(scan));
      ++vertices;
    } else if (statement == "f") {
      const int line = scan.line_number();
      const long long index = check_face(scan, vertices);
      if (index > highest) highest_line = line;
      highest = std::max(highest, index);
    }
  }
  if (highest > vertices) {
    throw InputError("line " + std::to_string(highest_line) + ": a face refers to vertex " +
                     std::to_string(highest) + " of " + std::to_string(vertices));
  }
}

}  // namespace prehend
