// Points of a mesh's surface, each standing for the same area, to which primitives are fitted.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/shape/triangle_mesh.h"

namespace prehend {

// A point of the surface in the mesh's frame O.
struct SurfacePoint {
  Vector3 p_O = Vector3::Zero();
  Vector3 n_O = Vector3::Zero();  // unit normal of its triangle
  int triangle = 0;               // index into TriangleMesh::triangles
};

// About `count` points, each standing for the same area: where lines along the columns of `axes`,
// on square grids that the seed moves, pass through the surface. A piece of surface with normal n
// meets |n_1| + |n_2| + |n_3| lines per area of a grid's cell, n_i along the axes, and of as many
// points one is kept. So the points depend on the surface and the axes, not on the triangles that
// the surface is divided into, nor on their order. Any stretch of them is spread over all of it.
//
// Normals point out of the volume that the mesh encloses as a whole; where triangles disagree, so
// do their points. Same arguments, same bytes on any platform. Empty for a mesh without area.
// Requires finite vertices and indices in range. The count of lines is Crofton's formula (Santalo
// 1976, Integral Geometry and Geometric Probability).
std::vector<SurfacePoint> sample_surface(const TriangleMesh& mesh, int count, std::uint64_t seed,
                                         const Matrix3& axes = Matrix3::Identity());

}  // namespace prehend
