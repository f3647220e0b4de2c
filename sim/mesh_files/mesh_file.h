// Reads triangle meshes from files: OBJ, STL, PLY, OFF, glTF, COLLADA.
#pragma once

#include <filesystem>
#include <string_view>

#include "sim/geometry/triangle_mesh.h"

namespace prehend {

// Metres in one unit of length: "m", "cm", "mm" or "in". Throws InputError on any other name.
double metres_per_unit(std::string_view unit);

// How the numbers of a file become metres and vertices.
struct MeshFileOptions {
  // Metres in one unit of the file, positive. COLLADA and glTF state their unit themselves; it is
  // applied first, so leave this at 1 for them unless the file lies.
  double metres_per_unit = 1.0;
  // Vertices closer than this fraction of the bounding-box diagonal become one (> 0, < 0.01).
  double weld_fraction = 1e-6;
};

// What a file holds once it is cleaned, and what was cleaned.
struct LoadedMesh {
  TriangleMesh mesh;           // welded; every vertex finite and used; metres
  int degenerate_removed = 0;  // triangles of no area or with a repeated vertex, left out
  int duplicates_removed = 0;  // triangles left out because they repeat another (weld.h)
};

// All triangles of all parts of the file, nodes placed by their transforms, polygons cut into
// triangles, lines and points left out; scaled to metres. The extension tells the format (.obj .stl
// .ply .off .gltf .glb .dae in any case). Axes are never turned: COLLADA's up_axis is ignored and
// glTF stays y-up. Windings are kept (see orient_outward). Materials and textures are not opened.
// Coordinates have single precision, as in most of these formats.
//
// Throws InputError, one line that starts with the file and names the defect, when the file is
// missing, unreadable, empty or above 1 GiB, of an unknown format, damaged (cut off, counts or
// indices out of range, coordinates that are not finite numbers), beyond 1e30 m, or without a
// triangle of positive area. Damage that assimp is known to crash or hang on, or to read as
// something else, is found before (mesh_bytes.h).
LoadedMesh load_mesh(const std::filesystem::path& file, const MeshFileOptions& options = {});

}  // namespace prehend
