// Distances on a grid.
#pragma once

#include <array>
#include <vector>

namespace prehend {

// Of each cell, the distance to the nearest cell whose entry in `from` is not 0, between the
// middles of cells [cells]; `far` where there is none. Exact (Felzenszwalb and Huttenlocher 2012).
// Cell (x, y, z) has index (z size[1] + y) size[0] + x; size[2] = 1 for a picture.
std::vector<float> distance_transform(const std::vector<char>& from, const std::array<int, 3>& size,
                                      float far);

}  // namespace prehend
