// Household objects as closed meshes of any density, made from their dimensions.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/shape/basic_shapes.h"
#include "sim/shape/triangle_mesh.h"

namespace prehend {

// The names that generate_object accepts: mug, wine_glass, phone, flask, bottle, bowl, box, ball,
// cylinder.
std::vector<std::string> generated_object_names();

// A closed, outward-oriented, manifold mesh [m] with roughly `triangles` triangles (within a factor
// of two, but at least as many as the shape needs). Every object stands on the plane z = 0 with its
// axis on the z axis; the mug's handle is on the +x side, the phone lies on its back with its long
// side along x. Mug, wine_glass, flask and bowl are hollow with a wall of finite thickness; the
// bottle stands for a full one and is solid, with its cap on. Equal arguments give equal meshes,
// bit by bit. Throws InputError for an unknown name or a count outside 1 to 2,000,000.
TriangleMesh generate_object(std::string_view name, int triangles = 5000);

}  // namespace prehend
