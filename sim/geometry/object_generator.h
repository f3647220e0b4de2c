// Household objects as closed meshes of any density, made from their dimensions.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/geometry/triangle_mesh.h"

namespace prehend {

// Names that generate_object knows: mug, wine_glass, phone, flask, bottle, bowl, box, ball, cylinder.
std::vector<std::string> generated_object_names();

// A closed, outward-oriented, manifold mesh with roughly `triangles` triangles (within a factor of
// two, and never below what the shape needs), z up, standing on or centred at the origin as the
// source states. Same arguments, same bytes.
// Throws InputError for an unknown name or fewer than 1 triangle.
TriangleMesh generate_object(std::string_view name, int triangles = 5000);

// The single shapes, centred at the origin, axis along z. Extents, radii, heights in metres, > 0.
TriangleMesh make_box(const Vector3& size, int cells_per_edge = 1);
TriangleMesh make_cylinder(double radius, double height, int sides = 48, int rings = 1);
TriangleMesh make_sphere(double radius, int subdivisions = 3);
// The polygon (counter-clockwise, simple, xy) swept from z = lower to z = upper.
TriangleMesh make_prism(const std::vector<Eigen::Vector2d>& polygon, double lower, double upper);

}  // namespace prehend
