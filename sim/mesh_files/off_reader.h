// Reads OFF files (Geomview's Object File Format).
#pragma once

#include <string_view>

#include "sim/geometry/triangle_mesh.h"

namespace prehend {

// Read here and not through assimp, which takes blank lines and comments between the lists for
// vertices and faces, leaves out faces of ten and more corners and moves indices that are out of
// range. Text OFF with any of the prefixes ST, C, N (whose extra columns are skipped); a vertex or
// a face a line; comments from # on; the count of edges may be missing. Faces are cut into
// triangles (triangulate_face); faces of one or two corners are left out. Not the 4, n and BINARY
// flavours. Throws InputError with the line number.
TriangleMesh read_off(std::string_view text);

}  // namespace prehend
