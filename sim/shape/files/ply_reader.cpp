// The header declares elements (vertex, face, others) with typed properties; the body is traversed
// as declared, and lengths, indices and coordinates are checked.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/base/formatted.h"
#include "sim/base/input_error.h"
#include "sim/shape/files/mesh_readers.h"
#include "sim/shape/files/text_scan.h"
#include "sim/shape/polygon.h"

namespace prehend {
namespace {

enum class Kind { unsigned_integer, signed_integer, real };

struct Scalar {
  Kind kind = Kind::real;
  std::size_t bytes = 4;
};

// One property of an element: a scalar, or a list with a count of type `count` and entries of type
// `value`.
struct Property {
  std::optional<Scalar> count;  // type of the count of a list
  Scalar value;
  int coordinate = -1;        // 0, 1, 2: x, y or z of a vertex
  bool vertex_index = false;  // the list of a face
};

struct Element {
  std::string name;
  long long count = 0;
  std::vector<Property> properties;
};

enum class Encoding { text, little_endian, big_endian };

// `end`: offset of the body; `lines`: number of lines of the header; `vertices`: count of element
// vertex.
struct Header {
  Encoding encoding = Encoding::text;
  std::vector<Element> elements;
  std::size_t end = 0;
  int lines = 0;
  long long vertices = 0;
};

Scalar scalar_named(const TextScan& scan, std::string_view name) {
  constexpr std::array<std::pair<std::string_view, Scalar>, 16> kScalars{{
      {"char", {Kind::signed_integer, 1}},
      {"int8", {Kind::signed_integer, 1}},
      {"uchar", {Kind::unsigned_integer, 1}},
      {"uint8", {Kind::unsigned_integer, 1}},
      {"short", {Kind::signed_integer, 2}},
      {"int16", {Kind::signed_integer, 2}},
      {"ushort", {Kind::unsigned_integer, 2}},
      {"uint16", {Kind::unsigned_integer, 2}},
      {"int", {Kind::signed_integer, 4}},
      {"int32", {Kind::signed_integer, 4}},
      {"uint", {Kind::unsigned_integer, 4}},
      {"uint32", {Kind::unsigned_integer, 4}},
      {"float", {Kind::real, 4}},
      {"float32", {Kind::real, 4}},
      {"double", {Kind::real, 8}},
      {"float64", {Kind::real, 8}},
  }};
  for (const auto& [known, scalar] : kScalars) {
    if (known == name) return scalar;
  }
  scan.fail("unknown PLY type " + in_quotes(name));
}

// "element NAME COUNT". Each takes at least a byte, so a count beyond the size of the file is
// wrong. Vertices and faces stand in one list each.
void read_element(TextScan& scan, Header& header, std::size_t file_size) {
  Element element;
  element.name = scan.next_word();
  const std::string_view word = scan.next_word();
  const std::optional<long long> count = integer_in(word);
  if (!count || *count < 0) scan.fail("a PLY element has the count " + in_quotes(word));
  if (*count > static_cast<long long>(file_size)) {
    scan.fail("promises " + std::to_string(*count) + " of element " + in_quotes(element.name) +
              ", more than the file can hold");
  }
  element.count = *count;
  for (const Element& other : header.elements) {
    if (other.name == element.name) scan.fail("element " + in_quotes(other.name) + " given twice");
  }
  if (element.name == "vertex") header.vertices = element.count;
  header.elements.push_back(std::move(element));
}

// "property TYPE NAME" or "property list COUNT_TYPE TYPE NAME", of the last element.
void read_property(TextScan& scan, Header& header) {
  if (header.elements.empty()) scan.fail("a PLY property of no element");
  Element& element = header.elements.back();
  Property property;
  std::string_view type = scan.next_word();
  if (type == "list") {
    property.count = scalar_named(scan, scan.next_word());
    if (property.count->kind == Kind::real) scan.fail("a PLY list counted in fractions");
    type = scan.next_word();
  }
  property.value = scalar_named(scan, type);
  const std::string_view name = scan.next_word();
  constexpr std::string_view kCoordinates = "xyz";
  if (element.name == "vertex" && !property.count && name.size() == 1 &&
      kCoordinates.find(name) != kCoordinates.npos) {
    property.coordinate = static_cast<int>(kCoordinates.find(name));
  }
  property.vertex_index = property.count && (name == "vertex_index" || name == "vertex_indices");
  element.properties.push_back(property);
}

// The surface must be what is read here: vertices with x, y and z, and faces with one list of their
// vertices. A surface of other elements (strips) would be left out without a word. Elements that
// hold no list of vertices (edge, material, camera) are no part of the surface.
void check_elements(const Header& header) {
  bool has_faces = false;
  for (const Element& element : header.elements) {
    std::array<int, 3> coordinates{};
    int lists = 0;
    for (const Property& property : element.properties) {
      if (property.coordinate >= 0) ++coordinates[static_cast<std::size_t>(property.coordinate)];
      lists += int{property.vertex_index};
    }
    if (element.name == "vertex" && coordinates != std::array<int, 3>{1, 1, 1}) {
      throw InputError("element vertex must have one x, one y and one z");
    }
    if (element.name == "face") {
      has_faces = true;
      if (lists != 1) throw InputError("element face must have one list vertex_indices");
    } else if (lists > 0 || element.name == "tristrips") {
      throw InputError("a surface of element " + in_quotes(element.name) +
                       " is not supported, only of faces");
    }
  }
  if (!has_faces) throw InputError("no triangles: there is no element face");
}

Header read_header(std::string_view bytes) {
  TextScan scan(bytes);
  if (!scan.next_line() || scan.next_word() != "ply") throw InputError("no PLY header");
  Header header;
  bool has_format = false;
  while (scan.next_line()) {
    const std::string_view word = scan.next_word();
    if (word == "format") {
      const std::string_view name = scan.next_word();
      has_format = true;
      if (name == "binary_little_endian") {
        header.encoding = Encoding::little_endian;
      } else if (name == "binary_big_endian") {
        header.encoding = Encoding::big_endian;
      } else if (name != "ascii") {
        scan.fail("unknown PLY format " + in_quotes(name));
      }
    } else if (word == "element") {
      read_element(scan, header, bytes.size());
    } else if (word == "property") {
      read_property(scan, header);
    } else if (word == "end_header") {
      if (!has_format) scan.fail("the PLY header names no format");
      header.end = scan.position();
      header.lines = scan.line_number();
      check_elements(header);
      return header;
    }  // other lines are comments, with or without the word for it
  }
  throw InputError("the PLY header does not end");
}

// Reads the scalars of the body one after another, in any encoding. Every scalar is returned as a
// double, which holds all 32-bit integers exactly. In text, values are words, and line breaks
// between them have no meaning.
class Body {
 public:
  Body(std::string_view bytes, const Header& header)
      : bytes_(bytes), text_(bytes), header_(header), at_(header.end) {
    // The text cursor starts over and passes the header, so that its line numbers count from the
    // start of the file.
    while (text_.position() < header.end && text_.next_line()) {
    }
    text_.next_word();  // end_header
  }

  double next(const Scalar& scalar, const Element& element) {
    return header_.encoding == Encoding::text ? next_word(element) : next_binary(scalar, element);
  }

  [[noreturn]] void fail(const std::string& what) const {
    if (header_.encoding == Encoding::text) text_.fail(what);
    throw InputError(what);
  }

 private:
  [[noreturn]] void too_short(const Element& element) const {
    fail("the file ends inside element " + in_quotes(element.name) + " (" +
         std::to_string(element.count) + " promised)");
  }

  double next_word(const Element& element) {
    std::string_view word = text_.next_word();
    while (word.empty()) {
      if (!text_.next_line()) too_short(element);
      word = text_.next_word();
    }
    const std::optional<double> value = number_in(word);
    if (!value) text_.fail("not a number (" + in_quotes(word) + ")");
    return *value;
  }

  // Copies the bytes in native order: reversed when the file has the other byte order.
  template <typename Value>
  double decoded(const char* data) const {
    std::array<char, sizeof(Value)> raw;
    const bool swap =
        (header_.encoding == Encoding::big_endian) != (std::endian::native == std::endian::big);
    for (std::size_t i = 0; i < raw.size(); ++i) raw[i] = data[swap ? raw.size() - 1 - i : i];
    return static_cast<double>(std::bit_cast<Value>(raw));
  }

  double next_binary(const Scalar& scalar, const Element& element) {
    if (bytes_.size() - at_ < scalar.bytes) too_short(element);
    const char* data = bytes_.data() + at_;
    at_ += scalar.bytes;
    if (scalar.kind == Kind::real) {
      return scalar.bytes == 4 ? decoded<float>(data) : decoded<double>(data);
    }
    const bool is_signed = scalar.kind == Kind::signed_integer;
    if (scalar.bytes == 1)
      return is_signed ? decoded<std::int8_t>(data) : decoded<std::uint8_t>(data);
    if (scalar.bytes == 2) {
      return is_signed ? decoded<std::int16_t>(data) : decoded<std::uint16_t>(data);
    }
    return is_signed ? decoded<std::int32_t>(data) : decoded<std::uint32_t>(data);
  }

  std::string_view bytes_;
  TextScan text_;
  const Header& header_;
  std::size_t at_;
};

// Reads a list; the entries of a face must be valid vertex indices, which are returned. A length
// within the limit fits an int. Comparisons are negated so that they also reject NaN.
std::vector<int> read_list(Body& body, const Property& property, const Element& element,
                           long long vertices) {
  constexpr double kLongest = 1e6;
  const double count = body.next(*property.count, element);
  if (!(count >= 0.0) || count > kLongest || count != std::floor(count)) {
    body.fail("a PLY list of length " + std::to_string(count));
  }
  std::vector<int> corners;
  for (int i = 0; i < static_cast<int>(count); ++i) {
    const double index = body.next(property.value, element);
    if (!property.vertex_index) continue;
    if (!(index >= 0.0) || index >= static_cast<double>(vertices) || index != std::floor(index)) {
      body.fail(formatted("a face refers to vertex %.10g of %lld", index, vertices));
    }
    corners.push_back(static_cast<int>(index));
  }
  return corners;
}

// Numbers beyond the range of float as infinity: to convert them is undefined.
double in_float_range(double value) {
  constexpr double kMost = std::numeric_limits<float>::max();
  return std::abs(value) > kMost ? std::numeric_limits<double>::infinity() : value;
}

// What of the body is kept.
struct Surface {
  std::vector<Vector3> vertices;
  std::vector<std::vector<int>> faces;
};

// Reads one entry of an element. Triangulation takes O(n^2) time, hence the limit of corners.
void read_entry(Body& body, const Header& header, const Element& element, Surface& surface) {
  constexpr std::size_t kMostCorners = 10'000;
  Vector3 vertex = Vector3::Zero();
  for (const Property& property : element.properties) {
    if (property.count) {
      std::vector<int> corners = read_list(body, property, element, header.vertices);
      if (corners.size() > kMostCorners) {
        body.fail("a face with " + std::to_string(corners.size()) + " corners, more than " +
                  std::to_string(kMostCorners));
      }
      if (corners.size() >= 3) surface.faces.push_back(std::move(corners));
      continue;
    }
    const double value = body.next(property.value, element);
    if (property.coordinate < 0) continue;
    vertex[property.coordinate] = static_cast<float>(in_float_range(value));
    if (!std::isfinite(vertex[property.coordinate])) {
      body.fail("vertex " + std::to_string(surface.vertices.size()) + " is not finite");
    }
  }
  if (element.name == "vertex") surface.vertices.push_back(vertex);
}

}  // namespace

// The body has no marks between its values: an element can be found only by reading everything
// before it. So all elements are read, also those that no mesh uses.
TriangleMesh read_ply(std::string_view bytes) {
  const Header header = read_header(bytes);
  Body body(bytes, header);
  Surface surface;
  for (const Element& element : header.elements) {
    for (long long i = 0; i < element.count; ++i) read_entry(body, header, element, surface);
  }
  // Faces may precede their vertices, so they are triangulated when all is read.
  TriangleMesh mesh{.vertices = std::move(surface.vertices), .triangles = {}};
  for (const std::vector<int>& face : surface.faces) add_triangles(mesh, face);
  return mesh;
}

}  // namespace prehend
