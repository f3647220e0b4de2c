#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/shape/files/mesh_readers.h"
#include "sim/shape/files/text_scan.h"
#include "sim/shape/polygon.h"

namespace prehend {
namespace {

// The next word of a statement; empty at its end or at a comment. A backslash at the end of a line
// continues the statement on the next one.
std::string_view next_word(TextScan& scan) {
  std::string_view word = scan.next_word();
  while (word == "\\" && scan.next_line()) word = scan.next_word();
  return word.starts_with('#') ? std::string_view() : word;
}

// A face may precede its vertices, so that its indices are checked when all is read.
struct Face {
  std::vector<int> corners;  // from 0
  int line = 0;
  std::size_t name = 0;  // which of the names so far
};

// Reads the rest of a face statement. Its indices count from 1, or, where negative, back from the
// last of the `vertices` read so far. In "v/vt/vn" only v is used. Triangulation takes O(n^2) time,
// hence the limit of corners.
Face read_face(TextScan& scan, std::size_t vertices) {
  constexpr std::size_t kMostCorners = 10'000;
  Face face{.corners = {}, .line = scan.line_number()};
  const auto known = static_cast<long long>(vertices);
  for (auto word = next_word(scan); !word.empty(); word = next_word(scan)) {
    const std::optional<long long> index = integer_in(word.substr(0, word.find('/')));
    if (!index || *index == 0 || *index > std::numeric_limits<int>::max()) {
      scan.fail("a face has the vertex " + in_quotes(word));
    }
    if (*index < -known) {
      scan.fail("a face refers to vertex " + std::to_string(*index) + " of " +
                std::to_string(known));
    }
    face.corners.push_back(static_cast<int>(*index < 0 ? known + *index : *index - 1));
    if (face.corners.size() > kMostCorners) {
      scan.fail("a face with more than " + std::to_string(kMostCorners) + " corners");
    }
  }
  return face;
}

// Statements that describe a curved surface, or a file to read more from, which would be missing
// without a word. Points and lines (p, l) and normals are no surface.
bool is_other_surface(std::string_view statement) {
  constexpr std::array<std::string_view, 22> kOthers{
      "vp",   "cstype", "deg", "bmat", "step", "curv", "curv2", "surf", "parm", "trim", "hole",
      "scrv", "sp",     "end", "con",  "call", "csh",  "fo",    "bzp",  "bsp",  "cdc",  "cdp"};
  return std::find(kOthers.begin(), kOthers.end(), statement) != kOthers.end();
}

// What follows the coordinates of a vertex: nothing, a weight, or a colour.
SurfaceColor color_after(TextScan& scan) {
  std::array<std::string_view, 4> words;
  std::size_t count = 0;
  while (count < words.size() && !(words[count] = next_word(scan)).empty()) ++count;
  if (count < 2) return std::nullopt;
  if (count != 3) {
    scan.fail("a vertex has " + std::string(count == 2 ? "2" : "more than 3") +
              " numbers after its coordinates, a colour has 3");
  }
  Eigen::Vector3f color;
  for (int k = 0; k < 3; ++k) {
    const std::string_view word = words[index(k)];
    const std::optional<double> number = number_in(word);
    const std::optional<float> part = number ? color_part(*number, 1.0) : std::nullopt;
    if (!part) scan.fail("a colour must have numbers from 0 to 1 (" + in_quotes(word) + ")");
    color[k] = *part;
  }
  return color;
}

void check_indices(const std::vector<Face>& faces, std::size_t vertices) {
  for (const Face& face : faces) {
    const int highest = *std::max_element(face.corners.begin(), face.corners.end());
    require(highest < static_cast<long long>(vertices),
            {.field = "line " + std::to_string(face.line),
             .problem = "a face refers to vertex " + std::to_string(highest + 1LL) + " of " +
                        std::to_string(vertices)});
  }
}

}  // namespace

NamedMesh read_obj(std::string_view text, bool colors) {
  need_text(text);
  TextScan scan(text);
  std::vector<Vector3> vertices;
  std::vector<SurfaceColor> vertex_colors;
  std::vector<Face> faces;
  std::string material;
  std::string part;
  std::vector<std::string> names = {""};
  while (scan.next_line()) {
    const std::string_view statement = scan.next_word();
    if (statement == "v") {
      Vector3& p = vertices.emplace_back();
      for (double& x : p) x = static_cast<float>(coordinate_in(scan, next_word(scan)));
      if (colors) vertex_colors.push_back(color_after(scan));
    } else if (statement == "f") {
      Face face = read_face(scan, vertices.size());
      face.name = names.size() - 1;
      if (face.corners.size() >= 3) faces.push_back(std::move(face));
    } else if (statement == "usemtl" || statement == "g" || statement == "o") {
      (statement == "usemtl" ? material : part) = next_word(scan).substr(0, kLongestName);
      if (names.size() == 2 * kMostNames) continue;
      std::string& name = names.emplace_back(material);
      name += ' ';
      name += part;
    } else if (is_other_surface(statement)) {
      scan.fail("only polygons are supported, not " + in_quotes(statement));
    }
  }
  check_indices(faces, vertices.size());
  if (faces.empty()) throw InputError("no faces");
  NamedMesh named{.mesh = {.vertices = std::move(vertices), .triangles = {}}};
  for (const Face& face : faces) {
    add_triangles(named.mesh, face.corners);
    named.name_rest(names[face.name]);
  }
  if (colors) named.color_rest_by_vertices(vertex_colors);
  return named;
}

}  // namespace prehend
