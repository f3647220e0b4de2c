// Reads the surfaces in Inventor 2 (.iv) and VRML 1 and 2 (.wrl) files in ascii.
#pragma once

#include <string_view>

#include "sim/shape/triangle_mesh.h"

namespace prehend {

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
