// Reads the surfaces of glTF 2 files: JSON text (.gltf) and binary (.glb).
#pragma once

#include <filesystem>
#include <string_view>

#include "sim/shape/triangle_mesh.h"

namespace prehend {

// All triangles of the default scene, or of all nodes in a file without scenes, with the transforms
// of the nodes applied, in metres; vertices are not merged. Triangles, strips and fans are read,
// points and lines left out. Buffers outside the file are regular *.bin files in `folder`.
// Materials, skins, morph targets, animations and extensions are ignored.
//
// Throws InputError, with the member of the document that is wrong: for what is not glTF 2, for
// compressed and sparse data, counts and indices out of range, nodes that contain themselves, and
// for nodes that together have more than 50 million vertices.
TriangleMesh read_gltf(std::string_view bytes, const std::filesystem::path& folder);
TriangleMesh read_glb(std::string_view bytes, const std::filesystem::path& folder);

}  // namespace prehend
