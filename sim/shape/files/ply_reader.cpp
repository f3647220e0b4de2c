// Of the elements that the header declares, vertices and faces are kept; lengths, indices and
// coordinates are checked.
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "sim/base/formatted.h"
#include "sim/base/input_error.h"
#include "sim/shape/files/mesh_readers.h"
#include "sim/shape/files/ply_elements.h"
#include "sim/shape/polygon.h"

namespace prehend {
namespace {

// PlyProperty::role: 0, 1, 2 for x, y or z of a vertex, and this for the list of a face's vertices.
constexpr int kVertexIndex = 3;

void set_roles(PlyHeader& header) {
  constexpr std::string_view kCoordinates = "xyz";
  for (PlyElement& element : header.elements) {
    for (PlyProperty& property : element.properties) {
      const std::string& name = property.name;
      if (property.count) {
        if (name == "vertex_index" || name == "vertex_indices") property.role = kVertexIndex;
      } else if (element.name == "vertex" && name.size() == 1 &&
                 kCoordinates.find(name) != kCoordinates.npos) {
        property.role = static_cast<int>(kCoordinates.find(name));
      }
    }
  }
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
      } else if (property.role >= 0) {
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
};

// Reads one entry of an element. Triangulation takes O(n^2) time, hence the limit of corners.
void read_entry(PlyBody& body, const PlyElement& element, long long vertices, Surface& surface) {
  constexpr std::size_t kMostCorners = 10'000;
  Vector3 vertex = Vector3::Zero();
  for (const PlyProperty& property : element.properties) {
    if (property.count) {
      std::vector<int> corners = read_list(body, property, element, vertices);
      if (corners.size() > kMostCorners) {
        body.fail("a face with " + std::to_string(corners.size()) + " corners, more than " +
                  std::to_string(kMostCorners));
      }
      if (corners.size() >= 3) surface.faces.push_back(std::move(corners));
      continue;
    }
    const double value = body.next(property.value, element);
    if (property.role < 0) continue;
    vertex[property.role] = static_cast<float>(in_float_range(value));
    if (!std::isfinite(vertex[property.role])) {
      body.fail("vertex " + std::to_string(surface.vertices.size()) + " is not finite");
    }
  }
  if (element.name == "vertex") surface.vertices.push_back(vertex);
}

}  // namespace

// The body has no marks between its values: an element can be found only by reading everything
// before it. So all elements are read, also those that no mesh uses.
TriangleMesh read_ply(std::string_view bytes) {
  PlyHeader header = read_ply_header(bytes);
  set_roles(header);
  check_elements(header);
  const PlyElement* vertex = header.element("vertex");
  const long long vertices = vertex == nullptr ? 0 : vertex->count;
  PlyBody body(bytes, header);
  Surface surface;
  for (const PlyElement& element : header.elements) {
    for (long long i = 0; i < element.count; ++i) read_entry(body, element, vertices, surface);
  }
  // Faces may precede their vertices, so they are triangulated when all is read.
  TriangleMesh mesh{.vertices = std::move(surface.vertices), .triangles = {}};
  for (const std::vector<int>& face : surface.faces) add_triangles(mesh, face);
  return mesh;
}

}  // namespace prehend
