#include "sim/shape/files/inventor_shapes.h"

#include <cmath>
#include <numbers>

#include "sim/shape/files/inventor_tokens.h"

namespace prehend {
namespace {

constexpr int kInventorSides = 20;
constexpr int kSphereSlices = 15;
constexpr int kSphereBands = 14;

double size_of(const InventorNode& node, const char* field, double otherwise) {
  const double size = node.number(field, otherwise);
  if (!(size > 0.0)) fail_in_line(node.line, "must be positive", field);
  return size;
}

// Whether the file has this part of a cylinder or cone: Inventor lists `name` among "parts", VRML 2
// has a flag for each.
bool has_part(const InventorNode& node, std::string_view name, std::string_view vrml2_flag) {
  if (const InventorField* parts = node.field("parts")) {
    for (const InventorWord& part : parts->words) {
      if (part.text == "ALL" || part.text == name) return true;
      if (part.text != "SIDES" && part.text != "TOP" && part.text != "BOTTOM") {
        fail_in_line(part.line, "no part is called so", part.text);
      }
    }
    return false;
  }
  return node.flag(vrml2_flag, true);
}

// Appends a circle about the y axis: corner k at the angle 2 pi k / count from -z,
// counter-clockwise seen from +y. Returns the index of its first vertex.
int add_circle(TriangleMesh& mesh, int count, double radius, double y) {
  const int first = static_cast<int>(mesh.vertices.size());
  for (int k = 0; k < count; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / count;
    mesh.vertices.emplace_back(-std::sin(angle) * radius, y, -std::cos(angle) * radius);
  }
  return first;
}

// The disc whose rim begins at vertex `first`, seen from +y or -y.
void add_disc(TriangleMesh& mesh, int first, int count, bool upward) {
  for (int k = 1; k + 1 < count; ++k) {
    mesh.triangles.push_back(upward ? Triangle{first, first + k, first + k + 1}
                                    : Triangle{first, first + k + 1, first + k});
  }
}

// The band between two circles of as many corners.
void add_band(TriangleMesh& mesh, int upper, int lower, int count) {
  for (int k = 0; k < count; ++k) {
    const int next = (k + 1) % count;
    mesh.triangles.push_back({upper + k, lower + k, lower + next});
    mesh.triangles.push_back({upper + k, lower + next, upper + next});
  }
}

// All triangles between a circle and a point on the axis.
void add_tip(TriangleMesh& mesh, int circle, int count, int tip, bool upward) {
  for (int k = 0; k < count; ++k) {
    const int next = (k + 1) % count;
    mesh.triangles.push_back(upward ? Triangle{tip, circle + k, circle + next}
                                    : Triangle{tip, circle + next, circle + k});
  }
}

TriangleMesh inventor_box(const Vector3& size) {
  TriangleMesh mesh;
  for (int corner = 0; corner < 8; ++corner) {
    mesh.vertices.emplace_back((corner & 1 ? 0.5 : -0.5) * size.x(),
                               (corner & 2 ? 0.5 : -0.5) * size.y(),
                               (corner & 4 ? 0.5 : -0.5) * size.z());
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

TriangleMesh inventor_cylinder(const InventorNode& node) {
  const double radius = size_of(node, "radius", 1.0);
  const double half = 0.5 * size_of(node, "height", 2.0);
  TriangleMesh mesh;
  const int top = add_circle(mesh, kInventorSides, radius, half);
  const int bottom = add_circle(mesh, kInventorSides, radius, -half);
  if (has_part(node, "SIDES", "side")) add_band(mesh, top, bottom, kInventorSides);
  if (has_part(node, "TOP", "top")) add_disc(mesh, top, kInventorSides, true);
  if (has_part(node, "BOTTOM", "bottom")) add_disc(mesh, bottom, kInventorSides, false);
  return mesh;
}

TriangleMesh inventor_cone(const InventorNode& node) {
  const double radius = size_of(node, "bottomRadius", 1.0);
  const double half = 0.5 * size_of(node, "height", 2.0);
  TriangleMesh mesh;
  const int rim = add_circle(mesh, kInventorSides, radius, -half);
  mesh.vertices.emplace_back(0.0, half, 0.0);
  if (has_part(node, "SIDES", "side")) add_tip(mesh, rim, kInventorSides, kInventorSides, true);
  if (has_part(node, "BOTTOM", "bottom")) add_disc(mesh, rim, kInventorSides, false);
  return mesh;
}

TriangleMesh inventor_sphere(double radius) {
  TriangleMesh mesh;
  mesh.vertices = {{0.0, radius, 0.0}, {0.0, -radius, 0.0}};
  int above = 0;
  for (int band = 1; band < kSphereBands; ++band) {
    const double angle = std::numbers::pi * band / kSphereBands;
    const int circle =
        add_circle(mesh, kSphereSlices, std::sin(angle) * radius, std::cos(angle) * radius);
    if (band == 1) {
      add_tip(mesh, circle, kSphereSlices, 0, true);
    } else {
      add_band(mesh, above, circle, kSphereSlices);
    }
    above = circle;
  }
  add_tip(mesh, above, kSphereSlices, 1, false);
  return mesh;
}

}  // namespace

std::optional<TriangleMesh> basic_inventor_shape(const InventorNode& node) {
  if (node.type == "Cube") {
    return inventor_box(
        {size_of(node, "width", 2.0), size_of(node, "height", 2.0), size_of(node, "depth", 2.0)});
  }
  if (node.type == "Box") {
    const Vector3 size = node.vector3("size", Vector3::Constant(2.0));
    if (!(size.minCoeff() > 0.0)) fail_in_line(node.line, "must be positive", "size");
    return inventor_box(size);
  }
  if (node.type == "Cylinder") return inventor_cylinder(node);
  if (node.type == "Cone") return inventor_cone(node);
  if (node.type == "Sphere") return inventor_sphere(size_of(node, "radius", 1.0));
  return std::nullopt;
}

}  // namespace prehend
