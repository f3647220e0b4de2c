// Triangle meshes as files: OBJ, STL, PLY and OFF.
#pragma once

#include <filesystem>
#include <string>

#include "sim/shape/triangle_mesh.h"

namespace prehend {

// The mesh in metres, with as many digits as read back to the same number, as Wavefront OBJ and as
// OFF; PLY as binary, little-endian, in double precision; STL as binary in single precision, with
// the corners of each triangle by themselves.
std::string obj_text(const TriangleMesh& mesh);
std::string off_text(const TriangleMesh& mesh);
std::string ply_bytes(const TriangleMesh& mesh);
std::string stl_bytes(const TriangleMesh& mesh);

// One of these by the extension of `file`. Throws InputError, which names the file, for another.
std::string mesh_text(const TriangleMesh& mesh, const std::filesystem::path& file);

// Whether mesh_text can write files with this name.
bool is_written_mesh_name(const std::filesystem::path& file);

}  // namespace prehend
