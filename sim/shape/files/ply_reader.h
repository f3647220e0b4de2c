// Reads PLY files, text and binary (Turk 1994, "The PLY Polygon File Format").
#pragma once

#include <string_view>

#include "sim/shape/triangle_mesh.h"

namespace prehend {

// Parses the elements vertex (x, y, z of any type, rounded to single precision) and face (one list
// of vertices, triangulated by triangulate_face; faces of one or two corners are left out). Other
// elements and properties are passed over. Throws InputError, with the line number in text files:
// for counts that exceed the file, indices out of range, coordinates that are not finite, surfaces
// other than faces.
TriangleMesh read_ply(std::string_view bytes);

}  // namespace prehend
