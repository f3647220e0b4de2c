// Reads triangle meshes from files: OBJ, STL, PLY, OFF, glTF, COLLADA, Inventor and VRML.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "sim/shape/files/mesh_color.h"
#include "sim/shape/triangle_mesh.h"

namespace prehend {

// Length of a unit in metres: of "m", "cm", "mm" or "in", or stated as a number, such as
// "0.0254". Throws InputError for any other name.
double metres_per_unit(std::string_view unit);

// Whether the extension of a file is one that load_mesh knows.
bool has_mesh_format(const std::filesystem::path& file);

// Whether the format of a file, by its extension, says the unit of its coordinates (glTF, COLLADA),
// or at least that it is the metre.
bool states_unit(const std::filesystem::path& file);

// How coordinates of a file are scaled and vertices merged.
struct MeshFileOptions {
  // Length of one unit of the file in metres, positive and finite. COLLADA and glTF declare their
  // own unit, which is applied first: leave 1 for them unless that unit is wrong.
  double metres_per_unit = 1.0;
  // Vertices closer than this fraction of the bounding-box diagonal are merged (> 0, < 0.01).
  double weld_fraction = 1e-6;
  bool part_surfaces = false;  // whether MeshPart::surface is wanted
  bool colors = false;         // whether LoadedMesh::colors are wanted
};

// A part of a mesh that its file names.
struct MeshPart {
  std::string name;           // of its material and of itself
  Bounds bounds;              // [m]
  TriangleMesh surface = {};  // as in the file, where it was asked for [m]
};

// The cleaned mesh of a file, and how much was removed.
struct LoadedMesh {
  TriangleMesh mesh;                 // welded; every vertex finite and used; metres
  int degenerate_removed = 0;        // triangles of no area or with a repeated vertex, left out
  int duplicates_removed = 0;        // triangles left out because they repeat another (weld.h)
  std::vector<MeshPart> parts = {};  // of OBJ, glTF and COLLADA; empty where there are over 1000
  ColoredMesh colors = {};           // of PLY, OBJ, glTF and COLLADA, where they were asked for
};

// All triangles of all parts of the file, with the transforms of its nodes applied, polygons
// triangulated, lines and points left out; scaled to metres. The extension determines the format
// (.obj .stl .ply .off .gltf .glb .dae .iv .wrl in upper or lower case). Axes are never turned:
// COLLADA's up_axis is ignored and glTF stays y-up. The winding of the file is kept (see
// orient_outward). Of materials the names are read, and colours
// where they are asked for. Coordinates have single precision, as in
// most of these formats.
//
// Throws InputError, one line that starts with the name of the file and states the defect, when the
// file is missing, unreadable, empty or larger than 1 GiB, has an unknown format, is damaged
// (truncated, counts or indices out of range, coordinates that are not finite numbers, colours that
// are asked for and out of range), has a
// coordinate beyond 1e6 m, or has no triangle of positive area.
LoadedMesh load_mesh(const std::filesystem::path& file, const MeshFileOptions& options = {});

// As load_mesh, of a file whose content is `bytes`. The file itself is not opened, only buffers
// that stand beside it.
LoadedMesh read_mesh(const std::string& bytes, const std::filesystem::path& file,
                     const MeshFileOptions& options = {});

}  // namespace prehend
