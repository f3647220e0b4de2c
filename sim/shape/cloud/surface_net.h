// A closed surface from signed distances on a grid.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "sim/base/index.h"
#include "sim/shape/triangle_mesh.h"

namespace prehend {

// Values at the corners of a grid: corner (x, y, z) is at lower + edge (x, y, z) and has the index
// (z size[1] + y) size[0] + x.
struct DistanceGrid {
  Vector3 lower = Vector3::Zero();
  double edge = 0.0;  // [m]
  std::array<int, 3> size{};
  std::vector<float> value;  // negative inside [m]

  std::size_t at(int x, int y, int z) const {
    return (index(z) * index(size[1]) + index(y)) * index(size[0]) + index(x);
  }
  Vector3 corner(int x, int y, int z) const { return lower + edge * Vector3(x, y, z); }
};

// Changes values next to 0, so that the surface between inside and outside has no edge that more
// than two faces share, nor a corner at which it touches itself; and makes the border of the grid,
// two corners wide, outside.
void make_well_composed(DistanceGrid& grid);

// The surface where the values are 0 (naive surface nets: Gibson 1998): closed, outward, with one
// vertex in each cell that it passes through, at the mean of where it crosses the cell's edges. The
// border of the grid must be outside.
TriangleMesh surface_net(const DistanceGrid& grid);

}  // namespace prehend
