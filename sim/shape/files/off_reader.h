// Reads OFF files (Geomview's Object File Format).
#pragma once

#include <string_view>

#include "sim/shape/triangle_mesh.h"

namespace prehend {

// Parses text OFF with any of the prefixes ST, C, N (whose extra columns are skipped); one vertex
// or face per line; comments from # to the end of the line; the count of edges may be missing.
// Faces are triangulated (triangulate_face); faces with one or two corners are left out. The
// variants 4OFF, nOFF and BINARY are not supported. Throws InputError with the line number.
TriangleMesh read_off(std::string_view text);

}  // namespace prehend
