// Points sampled from a mesh's surface in proportion to area, to which primitives are fitted.
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

// `count` points, each standing for the same area, in the order of the triangles. Normals point out
// of the volume that the mesh encloses as a whole; where triangles disagree, so do their points.
// Same arguments, same bytes on any platform. Empty for a mesh without area.
// Requires finite vertices and indices in range.
std::vector<SurfacePoint> sample_surface(const TriangleMesh& mesh, int count, std::uint64_t seed);

}  // namespace prehend
