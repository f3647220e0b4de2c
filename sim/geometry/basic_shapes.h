// Boxes, cylinders, spheres and prisms as closed, manifold, outward-oriented meshes.
#pragma once

#include <array>
#include <vector>

#include "sim/geometry/triangle_mesh.h"

namespace prehend {

// All lengths are in metres, finite and > 0; all counts are >= 1. Otherwise InputError.

// Centred at the origin, edges along the axes. 12 n^2 triangles for n cells per edge.
TriangleMesh make_box(const Vector3& size, int cells_per_edge = 1);

// The same box with its own number of cells along x, y and z.
TriangleMesh make_box_grid(const Vector3& size, const std::array<int, 3>& cells);

// Centred at the origin, axis along z: the prism over a regular polygon inscribed in the circle
// (sides >= 3, first corner on +x), its side cut into `rings` bands, its ends fans about the axis.
TriangleMesh make_cylinder(double radius, double height, int sides = 48, int rings = 1);

// Centred at the origin, vertices on the sphere: an icosahedron with every triangle cut in four
// `subdivisions` times (0 to 8), 20 * 4^subdivisions triangles.
TriangleMesh make_sphere(double radius, int subdivisions = 3);

// The same with every edge of the icosahedron cut in `frequency` parts: 20 frequency^2 triangles.
TriangleMesh make_geodesic_sphere(double radius, int frequency);

// The polygon (counter-clockwise, simple, xy) swept from z = lower to z = upper.
TriangleMesh make_prism(const std::vector<Eigen::Vector2d>& polygon, double lower, double upper);

}  // namespace prehend
