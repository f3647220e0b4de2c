// Triangulation of simple polygons in the plane and of polygonal faces in space.
#pragma once

#include <span>
#include <vector>

#include "sim/shape/triangle_mesh.h"

namespace prehend {

// Twice the signed area [m^2] of the polygon, positive when its corners are counter-clockwise.
double doubled_area(const std::vector<Eigen::Vector2d>& corners);

// Ear clipping (Meisters 1975), the best-shaped ear first: n - 2 counter-clockwise triangles of
// indices into `corners`, which use every corner. O(n^2). Corners with an angle of 180 degrees are
// allowed. Returns nothing when there is no such triangulation: fewer than three corners, not
// counter-clockwise, or intersecting itself.
std::vector<Triangle> triangulate_polygon(const std::vector<Eigen::Vector2d>& corners);

// The same for a polygon in space, projected to the plane of its mean normal (Newell's method):
// indices into `corners`, wound like the face. Where the projection has no triangulation (strongly
// bent or self-intersecting faces) the result is a fan about the first corner. Returns nothing for
// fewer than three corners.
std::vector<Triangle> triangulate_face(const std::vector<Vector3>& corners);

// Appends the triangles of a face whose corners are these vertices of the mesh.
void add_triangles(TriangleMesh& mesh, std::span<const int> face);

// The same for a strip of triangles, of which every second one is wound the other way, and for a
// fan, all of whose triangles have the first corner.
void add_strip(TriangleMesh& mesh, std::span<const int> strip);
void add_fan(TriangleMesh& mesh, std::span<const int> fan);

}  // namespace prehend
