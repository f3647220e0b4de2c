// Connected parts of a grid.
#pragma once

#include "sim/shape/cloud/surface_net.h"

namespace prehend {

// Makes outside what is inside without being connected, over edges of the grid, to a corner within
// one cell of one of `points`, but for parts that hold more than a tenth of all points; and makes
// inside what is outside without being connected to the border: hollows that nobody saw.
void keep_seen_parts(DistanceGrid& grid, const std::vector<Vector3>& points);

}  // namespace prehend
