// Points spread over a mesh's surface by area: what the fits see instead of triangles.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/geometry/triangle_mesh.h"

namespace prehend {

struct SurfacePoint {
  Vector3 p_O = Vector3::Zero();
  Vector3 n_O = Vector3::Zero();  // unit normal of its triangle
  int triangle = 0;
};

// `count` points, each standing for the same area, in the order of the triangles. Normals point out
// of the volume that the mesh encloses as a whole; where triangles disagree, so do their points.
// Same arguments, same bytes on any platform. Empty for a mesh without area.
// Requires finite vertices and indices in range.
std::vector<SurfacePoint> sample_surface(const TriangleMesh& mesh, int count, std::uint64_t seed);

}  // namespace prehend
