// Boxes, cylinders, spheres and prisms as closed, manifold meshes with outward-facing triangles.
#pragma once

#include <array>
#include <vector>

#include "sim/shape/triangle_mesh.h"

namespace prehend {

// All lengths are in metres. Every function throws InputError when a size is not positive and
// finite or a count is out of its range.

// A box centred at the origin with edges of lengths size.x, size.y and size.z along the axes: 12
// n^2 triangles for n cells per edge.
TriangleMesh make_box(const Vector3& size, int cells_per_edge = 1);

// The same box with cells[k] cells along axis k (1 to 10000 each).
TriangleMesh make_box_grid(const Vector3& size, const std::array<int, 3>& cells);

// A cylinder centred at the origin with its axis along z: the prism over a regular polygon with
// `sides` (3 to 100000) corners on the circle, the first on +x. Its lateral surface is divided into
// `rings` bands of equal height; each end is a fan of triangles about its centre.
TriangleMesh make_cylinder(double radius, double height, int sides = 48, int rings = 1);

// A sphere centred at the origin: an icosahedron whose triangles are each divided in four,
// `subdivisions` times (0 to 8), with all vertices on the sphere. 20 * 4^subdivisions triangles.
TriangleMesh make_sphere(double radius, int subdivisions = 3);

// The same with every edge of the icosahedron divided in `frequency` (1 to 2000) parts: 20
// frequency^2 triangles.
TriangleMesh make_geodesic_sphere(double radius, int frequency);

// The polygon in the xy plane (corners [m] counter-clockwise, simple) extruded from z = lower to z
// = upper [m]. Throws InputError when it cannot be split into triangles.
TriangleMesh make_prism(const std::vector<Eigen::Vector2d>& polygon, double lower, double upper);

}  // namespace prehend
