// The surfaces of single shape nodes of Inventor and VRML files, in the shape's own frame.
#pragma once

#include <optional>

#include "sim/shape/files/inventor_tree.h"
#include "sim/shape/triangle_mesh.h"

namespace prehend {

// Cube (VRML 2: Box), Cylinder, Cone or Sphere, without the parts that the file leaves out; nothing
// for other nodes. Curved surfaces have as many triangles as Coin makes of them at its usual
// complexity of 0.5, the ones that GraspIt! sees: 20 sides of a cylinder or cone, 15 by 14 patches
// of a sphere. Throws InputError with the line for sizes that are not positive.
std::optional<TriangleMesh> basic_inventor_shape(const InventorNode& node);

// What a shape made of faces takes from the nodes before it.
struct InventorCoordinates {
  const InventorField* points = nullptr;  // of Coordinate3; null: there were none
  bool clockwise = false;                 // corners of faces, seen from outside
};

// What the shapes of a file may still use: by using nodes again, a small file could ask for more
// triangles than memory holds.
struct InventorBudget {
  double triangles = 0.0;
  double polygon_work = 0.0;  // squares of numbers of corners
};

// FaceSet, IndexedFaceSet, TriangleStripSet or IndexedTriangleStripSet, counter-clockwise seen from
// outside; nothing for other nodes. Faces of less than three corners are left out. Throws
// InputError with the line for indices and counts out of range, coordinates that are not finite,
// faces of more than 10,000 corners, and a budget that is used up.
std::optional<TriangleMesh> inventor_faces(const InventorTree& tree, const InventorNode& node,
                                           const InventorCoordinates& before,
                                           InventorBudget& budget);

}  // namespace prehend
