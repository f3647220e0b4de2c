// Validation of Wavefront OBJ files and their reduction to vertices (v) and faces (f). Numbers are
// written again in a plain form, because assimp does not read ".5" as a number and drops the
// vertex; materials, normals and texture coordinates are left out.
#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string>
#include <vector>

#include "sim/base/input_error.h"
#include "sim/mesh_files/mesh_bytes.h"
#include "sim/mesh_files/text_scan.h"

namespace prehend {
namespace {

// The next word of a statement; empty at its end or at a comment. A backslash at the end of a line
// continues the statement on the next one.
std::string_view next_word(TextScan& scan) {
  std::string_view word = scan.next_word();
  while (word == "\\" && scan.next_line()) word = scan.next_word();
  return word.starts_with('#') ? std::string_view() : word;
}

// The shortest decimal form that reads back as the same number.
void append_number(std::string& text, double value) {
  std::array<char, 32> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  text += ' ';
  text.append(digits.data(), end);
}

// Vertex indices of a face, from 1. Negative indices count back from the last vertex read so far.
// In "v/vt/vn" only v is used.
std::vector<long long> face_vertices(TextScan& scan, long long vertices) {
  std::vector<long long> face;
  for (auto word = next_word(scan); !word.empty(); word = next_word(scan)) {
    const std::optional<long long> index = integer_in(word.substr(0, word.find('/')));
    if (!index || *index == 0) scan.fail("a face has the vertex " + in_quotes(word));
    if (*index < -vertices) {
      scan.fail("a face refers to vertex " + std::to_string(*index) + " of " +
                std::to_string(vertices));
    }
    face.push_back(*index < 0 ? vertices + 1 + *index : *index);
  }
  return face;
}

// Statements that describe a curved surface, or a file to read more from, which would be missing
// without a word. Points and lines (p, l), groups, names, normals and materials are no surface.
bool is_other_surface(std::string_view statement) {
  constexpr std::array<std::string_view, 22> kOthers{
      "vp",   "cstype", "deg", "bmat", "step", "curv", "curv2", "surf", "parm", "trim", "hole",
      "scrv", "sp",     "end", "con",  "call", "csh",  "fo",    "bzp",  "bsp",  "cdc",  "cdp"};
  return std::find(kOthers.begin(), kOthers.end(), statement) != kOthers.end();
}

}  // namespace

std::string checked_obj(std::string_view bytes) {
  need_text(bytes);
  TextScan scan(bytes);
  std::string reduced;
  reduced.reserve(bytes.size());
  long long vertices = 0;
  // A face may precede its vertices, so its indices are checked at the end: the highest one and its
  // line are kept.
  long long highest = 0;
  int highest_line = 0;
  while (scan.next_line()) {
    const std::string_view statement = scan.next_word();
    if (statement == "v") {
      reduced += 'v';
      for (int k = 0; k < 3; ++k) append_number(reduced, coordinate_in(scan, next_word(scan)));
      reduced += '\n';
      ++vertices;
    } else if (statement == "f") {
      const int line = scan.line_number();
      const std::vector<long long> face = face_vertices(scan, vertices);
      if (face.size() < 3) continue;
      reduced += 'f';
      for (const long long index : face) {
        reduced += ' ' + std::to_string(index);
        if (index > highest) highest_line = line;
        highest = std::max(highest, index);
      }
      reduced += '\n';
    } else if (is_other_surface(statement)) {
      scan.fail("only polygons are supported, not " + in_quotes(statement));
    }
  }
  if (highest > vertices) {
    throw InputError({.field = "line " + std::to_string(highest_line),
                      .problem = "a face refers to vertex " + std::to_string(highest) + " of " +
                                 std::to_string(vertices)});
  }
  if (highest == 0) throw InputError("no faces");
  return reduced;
}

}  // namespace prehend
