// Looks at the bytes of a mesh file before assimp gets them.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace prehend {

// Refuses what assimp is known to crash on, hang on or silently misread: counts that the file is
// too short for, text that is not text, coordinates that are not numbers, faces that refer to
// vertices that are not there, scene graphs with cycles. Passing it does not make a file valid.
// Returns the bytes to read instead: for OBJ and glTF only the parts that make up geometry, for
// binary STL without what follows the last triangle, else the same. glTF buffers outside the file
// are looked for in `folder`. Throws InputError, one line with the line number where there is one,
// not naming the file.
std::string checked_mesh_bytes(std::string_view extension, const std::string& bytes,
                               const std::filesystem::path& folder);

// Text must be UTF-8 or another superset of ASCII: no zero bytes, no UTF-16.
void need_text(std::string_view bytes);

// One for each format (in FORMAT_bytes.cpp).
std::string checked_obj(std::string_view bytes);
std::string checked_stl(std::string_view bytes);
void check_ply(std::string_view bytes);
void check_dae(std::string_view bytes);
std::string checked_gltf(std::string_view bytes, const std::filesystem::path& folder);
std::string checked_glb(std::string_view bytes, const std::filesystem::path& folder);

}  // namespace prehend
