// Household objects as closed meshes of any density, made from their dimensions.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/geometry/basic_shapes.h"
#include "sim/geometry/triangle_mesh.h"

namespace prehend {

// Names that generate_object knows: mug, wine_glass, phone, flask, bottle, bowl, box, ball,
// cylinder.
std::vector<std::string> generated_object_names();

// A closed, outward-oriented, manifold mesh with roughly `triangles` triangles (within a factor of
// two, and never below what the shape needs). Every object stands on the plane z = 0 with its axis
// on the z axis; the mug's handle is on the +x side, the phone lies on its back with its long side
// along x. Vessels (mug, wine_glass, flask, bowl) are hollow with a wall of their material; the
// bottle is a full one, solid inside, with its cap on. Same arguments, same bytes.
// Throws InputError for an unknown name or a count outside 1 to 2,000,000.
TriangleMesh generate_object(std::string_view name, int triangles = 5000);

}  // namespace prehend
