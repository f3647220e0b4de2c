// Of the elements that the header declares, vertices and faces are kept; lengths, indices and
// coordinates are checked.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/base/formatted.h"
#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/shape/files/mesh_readers.h"
#include "sim/shape/files/ply_elements.h"
#include "sim/shape/polygon.h"

namespace prehend {
namespace {

// PlyProperty::role: 0, 1, 2 for x, y or z of a vertex, and this for the list of a face's vertices.
constexpr int kVertexIndex = 3;
// And these for the parts of a colour, of a vertex or a face.
constexpr int kRed = 4;
constexpr std::array<std::string_view, 3> kColorParts{"red", "green", "blue"};

void set_roles(PlyHeader& header, bool colors) {
  constexpr std::string_view kCoordinates = "xyz";
  for (PlyElement& element : header.elements) {
    for (PlyProperty& property : element.properties) {
      const std::string& name = property.name;
      if (property.count) {
        if (name == "vertex_index" || name == "vertex_indices") property.role = kVertexIndex;
      } else if (element.name == "vertex" && name.size() == 1 &&
                 kCoordinates.find(name) != kCoordinates.npos) {
        property.role = static_cast<int>(kCoordinates.find(name));
      } else if (colors && (element.name == "vertex" || element.name == "face")) {
        const auto part = std::find(kColorParts.begin(), kColorParts.end(), name);
        if (part == kColorParts.end()) continue;
        property.role = kRed + static_cast<int>(part - kColorParts.begin());
      }
    }
  }
}

// What stands for the largest part of a colour; 0 for types that no colour has.
double full_color(const PlyScalar& type) {
  if (type.kind == PlyScalar::Kind::real) return 1.0;
  const bool is_unsigned = type.kind == PlyScalar::Kind::unsigned_integer;
  if (is_unsigned && type.bytes == 1) return 255.0;
  return is_unsigned && type.bytes == 2 ? 65535.0 : 0.0;
}

// Whether the element has a colour.
bool has_color(const PlyElement& element) {
  return std::any_of(element.properties.begin(), element.properties.end(),
                     [](const PlyProperty& property) { return property.role >= kRed; });
}

// Colours that were asked for must be whole.
void check_colors(const PlyElement& element) {
  std::array<int, 3> parts{};
  for (const PlyProperty& property : element.properties) {
    if (property.role < kRed) continue;
    ++parts[index(property.role - kRed)];
    require(full_color(property.value) > 0.0,
            {.problem = property.name + " of element " + element.name +
                        " must be uchar, ushort, float or double"});
  }
  require(parts == std::array<int, 3>{} || parts == std::array<int, 3>{1, 1, 1},
          {.problem = "element " + element.name + " must have one red, one green and one blue"});
}

// The surface must be what is read here: vertices with x, y and z, and faces with one list of their
// vertices. A surface of other elements (strips) would be left out without a word. Elements that
// hold no list of vertices (edge, material, camera) are no part of the surface.
void check_elements(const PlyHeader& header) {
  bool has_faces = false;
  for (const PlyElement& element : header.elements) {
    std::array<int, 3> coordinates{};
    int lists = 0;
    for (const PlyProperty& property : element.properties) {
      if (property.role == kVertexIndex) {
        ++lists;
      } else if (property.role >= 0 && property.role < kVertexIndex) {
        ++coordinates[static_cast<std::size_t>(property.role)];
      }
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

// Reads a list; the entries of a face must be valid vertex indices, which are returned.
// Comparisons are negated so that they also reject NaN.
std::vector<int> read_list(PlyBody& body, const PlyProperty& property, const PlyElement& element,
                           long long vertices) {
  const int count = body.next_length(property, element);
  std::vector<int> corners;
  for (int i = 0; i < count; ++i) {
    const double index = body.next(property.value, element);
    if (property.role != kVertexIndex) continue;
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
  std::vector<SurfaceColor> vertex_colors;  // where they have any
  std::vector<SurfaceColor> face_colors;    // where they have any
};

float read_color_part(PlyBody& body, const PlyProperty& property, double value) {
  const double full = full_color(property.value);
  const std::optional<float> part = color_part(value, full);
  if (!part)
    body.fail(
        formatted("%s must be from 0 to %.10g, not %.10g", property.name.c_str(), full, value));
  return *part;
}

// Reads one entry of an element. Triangulation takes O(n^2) time, hence the limit of corners.
void read_entry(PlyBody& body, const PlyElement& element, long long vertices, bool colored,
                Surface& surface) {
  constexpr std::size_t kMostCorners = 10'000;
  Vector3 vertex = Vector3::Zero();
  Eigen::Vector3f color = Eigen::Vector3f::Zero();
  std::vector<int> face;
  for (const PlyProperty& property : element.properties) {
    if (property.count) {
      std::vector<int> corners = read_list(body, property, element, vertices);
      if (corners.size() > kMostCorners) {
        body.fail("a face with " + std::to_string(corners.size()) + " corners, more than " +
                  std::to_string(kMostCorners));
      }
      if (property.role == kVertexIndex) face = std::move(corners);
      continue;
    }
    const double value = body.next(property.value, element);
    if (property.role < 0) continue;
    if (property.role >= kRed) {
      color[property.role - kRed] = read_color_part(body, property, value);
      continue;
    }
    vertex[property.role] = static_cast<float>(in_float_range(value));
    if (!std::isfinite(vertex[property.role])) {
      body.fail("vertex " + std::to_string(surface.vertices.size()) + " is not finite");
    }
  }
  if (element.name == "vertex") {
    surface.vertices.push_back(vertex);
    if (colored) surface.vertex_colors.emplace_back(color);
  }
  if (face.size() < 3) return;
  surface.faces.push_back(std::move(face));
  if (colored) surface.face_colors.emplace_back(color);
}

// The triangles of all faces. Faces may precede their vertices, so they are triangulated when all
// is read.
NamedMesh mesh_of(Surface&& surface) {
  NamedMesh named{.mesh = {.vertices = std::move(surface.vertices), .triangles = {}}};
  for (std::size_t f = 0; f < surface.faces.size(); ++f) {
    add_triangles(named.mesh, surface.faces[f]);
    if (!surface.face_colors.empty()) named.color_rest(surface.face_colors[f]);
  }
  if (!surface.vertex_colors.empty()) named.color_rest_by_vertices(surface.vertex_colors);
  return named;
}

}  // namespace

// The body has no marks between its values: an element can be found only by reading everything
// before it. So all elements are read, also those that no mesh uses.
NamedMesh read_ply(std::string_view bytes, bool colors) {
  PlyHeader header = read_ply_header(bytes);
  set_roles(header, colors);
  check_elements(header);
  const PlyElement* vertex = header.element("vertex");
  const long long vertices = vertex == nullptr ? 0 : vertex->count;
  PlyBody body(bytes, header);
  Surface surface;
  for (const PlyElement& element : header.elements) {
    const bool colored = has_color(element);
    if (colored) check_colors(element);
    for (long long i = 0; i < element.count; ++i) {
      read_entry(body, element, vertices, colored, surface);
    }
  }
  return mesh_of(std::move(surface));
}

}  // namespace prehend
