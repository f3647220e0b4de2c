// Reads a mesh file with assimp. assimp is used behind this header only.
#pragma once

#include <string>

#include "sim/shape/triangle_mesh.h"

namespace prehend {

// All triangles of all nodes of the file, with the transforms of the nodes applied, polygons
// triangulated (triangulate_face), points and lines left out and vertices not merged. COLLADA
// lengths are multiplied by the file's own metres per unit; axes are never turned, whatever the
// file declares as up. `bytes` is the whole content of a file of the format `extension` ("glb" or
// "dae"); no files are opened: no buffers, no materials, no textures. Throws InputError with a
// one-line message.
TriangleMesh read_with_assimp(const std::string& bytes, const std::string& extension);

}  // namespace prehend
