// The separate pieces of a solid.
#pragma once

#include <vector>

#include "sim/shape/mass_solid.h"

namespace prehend {

// A piece of the surface of a solid whose triangles are connected by shared vertices, with the
// cavities in it.
struct SolidComponent {
  TriangleMesh surface;
  Moments moments;
};

// In the order of their volumes, the largest first; of equal ones the one whose triangles come
// first. A piece that faces inward is a cavity of the smallest component whose bounds contain it,
// or a component of its own where none does. Frame and scale are those of `solid`, which must have
// components.
std::vector<SolidComponent> solid_components(const MassSolid& solid);

}  // namespace prehend
