// Reads STL files, text and binary.
#pragma once

#include <string_view>

#include "sim/shape/triangle_mesh.h"

namespace prehend {

// Parses the facets, each into three vertices of its own, with coordinates of single precision. Of
// text files all solids are read, keywords in upper or lower case; of a facet the first three
// vertices. Bytes after the last facet of a binary file are ignored, and so are normals: the order
// of the vertices says which way a facet faces. Throws InputError, with the line number in text
// files.
TriangleMesh read_stl(std::string_view bytes);

}  // namespace prehend
