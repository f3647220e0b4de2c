// Random objects to grasp: shapes of many kinds and sizes, some of them with the faults that meshes
// have in practice.
#pragma once

#include <string>

#include "sim/base/random.h"
#include "sim/shape/triangle_mesh.h"

namespace prehend::soak {

struct RandomObject {
  TriangleMesh mesh;  // [m], as make_mesh returns it
  std::string words;  // what it is: "mug, 0.8 x 1.2 x 1.0, holes"
  // It bounds a solid by construction: closed, without self-intersections.
  bool solid = true;
};

// Largest dimension between 2.1 mm (kSmallestObject is 2 mm) and 1 m, most of them as large as what
// hands hold; about 12 to 3000 triangles.
RandomObject random_object(Random& random);

}  // namespace prehend::soak
