// Mesh simplification for display, by vertex clustering (Rossignac and Borrel 1993).
#pragma once

#include "sim/shape/triangle_mesh.h"

namespace prehend {

// The mesh with at most `most` (>= 1) triangles. Vertices near each other are joined, in cells as
// large as needed; where that would leave no triangle, evenly picked ones stay. Good enough to look
// at; not for measuring.
TriangleMesh simplified(const TriangleMesh& mesh, std::size_t most);

}  // namespace prehend
