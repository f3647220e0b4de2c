// Solids made of hexahedra: the finite elements of pads that give way.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "sim/base/pose.h"

namespace prehend {

// Corners of one element, indices into the nodes: 0 to 3 counter-clockwise around the bottom as
// seen from the top, 4 to 7 above them.
using Hexahedron = std::array<int, 8>;

// Hexahedra that share nodes where they meet. Hexahedra, because linear tetrahedra are far too
// stiff in nearly incompressible materials such as rubber, and quadratic ones have corner nodes on
// which a uniform pressure exerts no force, so that contact forces at nodes are not pressures.
struct HexMesh {
  std::vector<Vector3> nodes;  // [m]
  std::vector<Hexahedron> elements;
};

// A block whose nodes lie at all combinations of the ascending coordinates [m], at least two an
// axis; node (i, j, k) has the index (k * y.size() + j) * x.size() + i. Throws InputError
// otherwise.
HexMesh block_mesh(std::span<const double> x, std::span<const double> y, std::span<const double> z);

}  // namespace prehend
