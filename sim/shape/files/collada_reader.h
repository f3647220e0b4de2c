// Reads the surfaces of COLLADA files (.dae).
#pragma once

#include <filesystem>
#include <string>

#include "sim/shape/triangle_mesh.h"

namespace prehend {

// All polygons of the visual scene that the document instantiates, with the transforms of its nodes
// applied, triangulated (add_triangles), in the file's own metres per unit; vertices are not
// merged. Axes are never turned, whatever the file declares as up. Read are triangles, polylist,
// polygons and tristrips; lines and points are left out. A controller stands for the geometry that
// it deforms. `file` is only named in errors.
//
// Throws InputError "FILE: line 12, <p>: problem": for what XmlFile refuses, for other surfaces
// (polygons with holes, fans, splines, bodies by their borders), counts and indices that do not fit
// their lists, references to what is not in the file, nodes that contain themselves, and for nodes
// that stand for more than 100,000 nodes or 50 million vertices.
TriangleMesh read_collada(const std::string& bytes, const std::filesystem::path& file);

}  // namespace prehend
