// Reads triangle meshes from files: OBJ, STL, PLY, OFF, glTF, COLLADA.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "sim/geometry/triangle_mesh.h"

namespace prehend {

// Metres in one unit of length: "m", "cm", "mm" or "in". Throws InputError on any other name.
double metres_per_unit(std::string_view unit);

struct MeshFileOptions {
  // Metres in one unit of the file.
  double metres_per_unit = 1.0;
  // Vertices closer than this fraction of the bounding-box diagonal become one (> 0, < 0.01).
  double weld_fraction = 1e-6;
};

struct LoadedMesh {
  TriangleMesh mesh;           // welded; every vertex finite and used; metres
  int degenerate_removed = 0;  // triangles of no area or with a repeated vertex, left out
  int duplicates_removed = 0;  // triangles with the same three vertices as an earlier one, left out
};

// All triangles of all parts of the file, in the file's own frame and axes, scaled to metres.
// Throws InputError, one line that names the file and the defect, when the file is missing or
// unreadable, of an unknown format, without a triangle of positive area, or not finite.
LoadedMesh load_mesh(const std::filesystem::path& file, const MeshFileOptions& options = {});

}  // namespace prehend
