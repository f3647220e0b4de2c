// Meshes with more triangles than a picture shows.
#pragma once

#include "sim/geometry/triangle_mesh.h"

namespace prehend {

// The mesh with at most `most` (>= 1) triangles: vertices near each other joined, as far as needed;
// where that would leave nothing, some of its triangles. To be looked at, not to be measured.
TriangleMesh simplified(const TriangleMesh& mesh, std::size_t most);

}  // namespace prehend
