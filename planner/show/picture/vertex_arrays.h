// A mesh as indexed vertex arrays for graphics hardware: one normal a vertex, single precision.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim/shape/triangle_mesh.h"

namespace prehend {

// In the mesh's frame, metres; normals are unit. Every vertex is used, and no two are the same.
struct VertexArrays {
  std::vector<std::array<float, 3>> positions;
  std::vector<std::array<float, 3>> normals;            // as many as positions
  std::vector<std::array<std::uint32_t, 3>> triangles;  // counter-clockwise from outside
};

// Faces that meet at less than `crease_angle` (radians) are shaded as one round surface, as in
// surface_detail.h; a vertex is split only where its normals differ. Triangles without area are
// left out. Throws InputError for vertices that are not finite in single precision and for indices
// out of range.
VertexArrays vertex_arrays(const TriangleMesh& mesh, double crease_angle);

}  // namespace prehend
