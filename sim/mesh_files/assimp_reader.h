// The one place that knows assimp: bytes of a mesh file to triangles as they stand in the file.
#pragma once

#include <filesystem>
#include <string>

#include "sim/geometry/triangle_mesh.h"

namespace prehend {

// All triangles of all nodes of the scene, each node's transforms applied, polygons cut into
// triangles (triangulate_face), points and lines left out, vertices not joined. COLLADA lengths are
// multiplied by the file's own metres per unit; axes are never turned, whatever the file calls up.
// `extension` chooses the format ("obj", "stl", "ply", "gltf", "glb", "dae"). Nothing but
// `bytes` and, for glTF, *.bin files beside `file` is read: no materials, no textures.
// Throws InputError with a one-line message that does not yet name the file.
TriangleMesh read_with_assimp(const std::filesystem::path& file, const std::string& extension,
                              const std::string& bytes);

}  // namespace prehend
