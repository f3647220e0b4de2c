// Reads Wavefront OBJ files.
#pragma once

#include <string_view>

#include "sim/shape/triangle_mesh.h"

namespace prehend {

// Parses vertices (v), with coordinates of single precision, and faces (f, triangulated by
// triangulate_face; faces of one or two corners are left out), which may come before their
// vertices. Points, lines, groups, names, normals, texture coordinates and materials are ignored;
// curved surfaces and references to other files are errors, because a part of the surface would be
// missing. Throws InputError with the line number.
TriangleMesh read_obj(std::string_view text);

}  // namespace prehend
