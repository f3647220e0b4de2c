// Readers of the mesh formats, each from the whole content of a file (mesh_file.h reads files).
// What they return is in the unit of the file, with vertices not merged; coordinates have single
// precision. All throw InputError, one line with the place where there is one.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "sim/shape/files/mesh_color.h"
#include "sim/shape/triangle_mesh.h"

namespace prehend {

// Consecutive triangles of a file that have one material and belong to one part.
struct NamedTriangles {
  std::string name;  // the file's words for material and part, with a space between them
  std::size_t count = 0;
};

// What a file says, with names for all triangles in their order. Where there are more than
// kMostNames, the last one stands for all that follow.
struct NamedMesh {
  TriangleMesh mesh = {};
  std::vector<NamedTriangles> names = {};
  std::size_t named = 0;                  // triangles
  std::vector<SurfaceColor> colors = {};  // of all triangles where they were asked for, else empty

  // Names the triangles that no name counts yet, by its first 2 * kLongestName characters.
  void name_rest(std::string_view name) { add_name(name, mesh.triangles.size() - named); }
  // Names that many more.
  void add_name(std::string_view name, std::size_t count);
  // Gives the triangles without an entry in `colors` this one, or the mean of their corners
  // (mean_color).
  void color_rest(const SurfaceColor& color) { colors.resize(mesh.triangles.size(), color); }
  void color_rest_by_vertices(const std::vector<SurfaceColor>& of_vertices, std::size_t first = 0);
};
inline constexpr std::size_t kMostNames = 1000;
inline constexpr std::size_t kLongestName = 100;  // of a material or a part [characters]

// Readers take `colors`: whether those of the surface are wanted, which are passed over otherwise.
// They must be numbers from 0 to 1, or whole ones up to what their type holds.

// Wavefront OBJ.
//
// Parses vertices (v), with coordinates of single precision, and faces (f, triangulated by
// triangulate_face; faces of one or two corners are left out), which may come before their
// vertices. Names are those of usemtl and of the last g or o. Points, lines, normals and texture
// coordinates are ignored; curved surfaces and references to other files are errors, because a part
// of the surface would be missing. Colours are three numbers after the coordinates of a vertex; a
// single one is a weight, as in curved surfaces. Throws InputError with the line number.
NamedMesh read_obj(std::string_view text, bool colors = false);

// STL, text and binary.
//
// Parses the facets, each into three vertices of its own, with coordinates of single precision. Of
// text files all solids are read, keywords in upper or lower case; of a facet the first three
// vertices. Bytes after the last facet of a binary file are ignored, and so are normals: the order
// of the vertices says which way a facet faces. Throws InputError, with the line number in text
// files.
TriangleMesh read_stl(std::string_view bytes);

// PLY, text and binary (Turk 1994, "The PLY Polygon File Format").
//
// Parses the elements vertex (x, y, z of any type, rounded to single precision) and face (one list
// of vertices, triangulated by triangulate_face; faces of one or two corners are left out). Other
// elements and properties are passed over. Colours are red, green and blue of faces, else of
// vertices: uchar, ushort, float or double. Throws InputError, with the line number in text files:
// for counts that exceed the file, indices out of range, coordinates that are not finite, surfaces
// other than faces.
NamedMesh read_ply(std::string_view bytes, bool colors = false);

// OFF (Geomview's Object File Format).
//
// Parses text OFF with any of the prefixes ST, C, N (whose extra columns are skipped); one vertex
// or face per line; comments from # to the end of the line; the count of edges may be missing.
// Faces are triangulated (triangulate_face); faces with one or two corners are left out. The
// variants 4OFF, nOFF and BINARY are not supported. Throws InputError with the line number.
TriangleMesh read_off(std::string_view text);

// glTF 2, JSON text (.gltf) and binary (.glb).
//
// All triangles of the default scene, or of all nodes in a file without scenes, with the transforms
// of the nodes applied, in metres; vertices are not merged. Triangles, strips and fans are read,
// points and lines left out. Buffers outside the file are regular *.bin files in `folder`. Names
// are those of materials and nodes. Colours are the product of COLOR_0 and baseColorFactor, or the
// one of them that is there, turned from light to sRGB. Skins, morph targets, animations, textures
// and extensions are ignored.
//
// Throws InputError, with the member of the document that is wrong: for what is not glTF 2, for
// compressed and sparse data, counts and indices out of range, nodes that contain themselves, and
// for nodes that together have more than 50 million vertices.
NamedMesh read_gltf(std::string_view bytes, const std::filesystem::path& folder,
                    bool colors = false);
NamedMesh read_glb(std::string_view bytes, const std::filesystem::path& folder,
                   bool colors = false);

// COLLADA (.dae).
//
// All polygons of the visual scene that the document instantiates, with the transforms of its nodes
// applied, triangulated (add_triangles), in the file's own metres per unit; vertices are not
// merged. Axes are never turned, whatever the file declares as up. Read are triangles, polylist,
// polygons and tristrips; lines and points are left out. Names are the symbols of materials and
// those of geometries. Colours are the diffuse ones of materials (profile_COMMON) as they are
// written. A controller stands for the geometry that it deforms. `file` is only named in errors.
//
// Throws InputError "FILE: line 12, <p>: problem": for what XmlFile refuses, for other surfaces
// (polygons with holes, fans, splines, bodies by their borders), counts and indices that do not fit
// their lists, references to what is not in the file, nodes that contain themselves, and for nodes
// that stand for more than 100,000 nodes or 50 million vertices.
NamedMesh read_collada(const std::string& bytes, const std::filesystem::path& file,
                       bool colors = false);

// Inventor 2 (.iv) and VRML 1 and 2 (.wrl) in ascii.
//
// All surfaces of the file with the transforms of its nodes applied, in the unit of the file. The
// header says which language it is, whatever the extension: #Inventor V2.x ascii, #VRML V1.0 ascii
// or #VRML V2.0 utf8.
//
// Read are the nodes that group (Separator, TransformSeparator, Group, Switch, LOD and the like),
// that place (Transform, Translation, Rotation, RotationXYZ, Scale, MatrixTransform; Units, which
// scales what follows from the units before it, metres at first), and that have
// a surface: Cube, Box, Cylinder, Cone, Sphere, FaceSet, IndexedFaceSet, TriangleStripSet,
// IndexedTriangleStripSet, with Coordinate3, ShapeHints, VertexProperty, Shape and Coordinate; DEF
// and USE. Other nodes are skipped (colours, normals, lights, lines, ...).
//
// Throws InputError, one line with the line number: for what parse_inventor (inventor_tree.h),
// inventor_shapes.h and inventor_transforms.h refuse, for a node that has or contains a surface but
// is none of the above, by its name, and for a file whose nodes are used again so often that it
// would have millions of triangles more than bytes.
TriangleMesh read_inventor(std::string_view text);

}  // namespace prehend
