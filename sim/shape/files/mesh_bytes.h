// Validates the bytes of a mesh file before assimp parses them.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace prehend {

// Rejects input on which assimp is known to crash, hang or return wrong data: counts that exceed
// the file, binary data in text, coordinates that are not numbers, faces with vertex indices out of
// range, cyclic scene graphs. A file that passes may still be invalid.
// Returns the bytes for assimp: for COLLADA all, for glTF (text and binary) a GLB of the parts that
// define geometry, with the data of all buffers. Buffers outside the file are searched in `folder`.
// Throws InputError, one line with the line number where there is one, without the name of the
// file.
std::string checked_mesh_bytes(std::string_view extension, const std::string& bytes,
                               const std::filesystem::path& folder);

// Throws InputError unless the text may be UTF-8 or another superset of ASCII: no zero bytes, no
// byte order mark of UTF-16.
void need_text(std::string_view bytes);

// The checks of each format (in FORMAT_bytes.cpp). Functions named checked_ return the GLB to read.
void check_dae(std::string_view bytes);
std::string checked_gltf(std::string_view bytes, const std::filesystem::path& folder);
std::string checked_glb(std::string_view bytes, const std::filesystem::path& folder);

}  // namespace prehend
