#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "sim/base/input_error.h"
#include "sim/shape/files/mesh_readers.h"
#include "sim/shape/files/text_scan.h"
#include "sim/shape/polygon.h"

// OFF: an optional keyword, the numbers of vertices, faces and edges, a line for each vertex and a
// line for each face. The keyword may have a prefix that tells
// what else is given for each vertex: ST texture coordinates, C a colour, N a normal; these follow
// the three coordinates and are ignored. Other prefixes (4, n) change the number of coordinates,
// and such files are rejected.
namespace prehend {
namespace {

// Lines split into words; blank lines and comments are skipped.
class OffLines {
 public:
  explicit OffLines(std::string_view text) : scan_(text) {}

  // False at the end of the text.
  bool next_line() {
    while (scan_.next_line()) {
      words_.clear();
      for (auto word = scan_.next_word(); !word.empty(); word = scan_.next_word()) {
        const std::size_t comment = word.find('#');
        if (comment != 0) words_.push_back(word.substr(0, comment));
        if (comment != word.npos) break;
      }
      if (!words_.empty()) return true;
    }
    return false;
  }

  void need_line(const std::string& what) {
    if (!next_line()) scan_.fail("the file ends before " + what);
  }

  const TextScan& scan() const { return scan_; }
  std::vector<std::string_view>& words() { return words_; }

  long long integer(std::size_t i, const std::string& what) const {
    const std::string_view word = i < words_.size() ? words_[i] : std::string_view();
    const std::optional<long long> value = integer_in(word);
    if (!value) scan_.fail(what + " is not a whole number (" + in_quotes(word) + ")");
    return *value;
  }

 private:
  TextScan scan_;
  std::vector<std::string_view> words_;
};

// Reads the header keyword (OFF with a prefix, or nothing) and removes it, so that the words that
// remain are the counts, which may be on the same or the next line.
void read_keyword(OffLines& lines) {
  if (!lines.next_line()) throw InputError("no OFF header");
  std::string_view& first = lines.words().front();
  const std::size_t at = first.find("OFF");
  if (at == first.npos) {
    // The keyword may be missing.
    if (!integer_in(first)) lines.scan().fail("not an OFF header (" + in_quotes(first) + ")");
    return;
  }
  const std::string_view prefix = first.substr(0, at);
  const bool known = prefix.find_first_not_of("STCN") == prefix.npos;
  const bool binary = lines.words().size() > 1 && lines.words()[1] == "BINARY";
  if (!known || binary) lines.scan().fail("only three-dimensional text OFF can be read");
  first.remove_prefix(at + 3);
  if (first.empty()) lines.words().erase(lines.words().begin());
  if (lines.words().empty()) lines.need_line("the counts");
}

// Reads "n v1 ... vn"; further words on the line are colours and are ignored.
void read_face(OffLines& lines, TriangleMesh& mesh) {
  constexpr long long kMostCorners = 10'000;
  const long long corners = lines.integer(0, "the number of corners of a face");
  if (corners < 1 || corners > kMostCorners) {
    lines.scan().fail("a face of " + std::to_string(corners) + " corners");
  }
  std::vector<int> face;
  for (long long k = 1; k <= corners; ++k) {
    const long long v = lines.integer(static_cast<std::size_t>(k), "a vertex of a face");
    if (v < 0 || v >= static_cast<long long>(mesh.vertices.size())) {
      lines.scan().fail("a face refers to vertex " + std::to_string(v) + " of " +
                        std::to_string(mesh.vertices.size()));
    }
    face.push_back(static_cast<int>(v));
  }
  add_triangles(mesh, face);
}

}  // namespace

TriangleMesh read_off(std::string_view text) {
  OffLines lines(text);
  read_keyword(lines);
  const long long vertices = lines.integer(0, "the number of vertices");
  const long long faces = lines.integer(1, "the number of faces");
  // Every vertex and every face takes a line of at least two bytes.
  const long long most = static_cast<long long>(text.size() / 2) + 1;
  if (vertices < 0 || faces < 0 || vertices > most || faces > most) {
    lines.scan().fail("promises " + std::to_string(vertices) + " vertices and " +
                      std::to_string(faces) + " faces, more than the file can hold");
  }
  TriangleMesh mesh;
  for (long long i = 0; i < vertices; ++i) {
    lines.need_line("vertex " + std::to_string(i) + " of " + std::to_string(vertices));
    Vector3 p;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::string_view word =
          k < lines.words().size() ? lines.words()[k] : std::string_view();
      p[static_cast<Eigen::Index>(k)] = coordinate_in(lines.scan(), word);
    }
    mesh.vertices.push_back(p);
  }
  for (long long i = 0; i < faces; ++i) {
    lines.need_line("face " + std::to_string(i) + " of " + std::to_string(faces));
    read_face(lines, mesh);
  }
  return mesh;
}

}  // namespace prehend
