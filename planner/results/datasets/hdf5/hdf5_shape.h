// The extents of an array.
#pragma once

#include <cstddef>
#include <vector>

namespace prehend {

// The slowest first; empty: a scalar.
using Hdf5Shape = std::vector<std::size_t>;

}  // namespace prehend
