// Reads a mesh file with assimp. assimp is used behind this header only.
#pragma once

#include <filesystem>
#include <string>

#include "sim/geometry/triangle_mesh.h"

namespace prehend {

// All triangles of all nodes of the file, with the transforms of the nodes applied, polygons
// triangulated (triangulate_face), points and lines left out and vertices not merged. COLLADA
// lengths are multiplied by the file's own metres per unit; axes are never turned, whatever the
// file declares as up. `extension` selects the format ("gltf", "glb", "dae").
// `bytes` is the content of `file`; apart from it only *.bin files of glTF are opened: no
// materials, no textures. Throws InputError with a one-line message that does not name the file.
TriangleMesh read_with_assimp(const std::filesystem::path& file, const std::string& extension,
                              const std::string& bytes);

}  // namespace prehend
