// Improves a whole set of regions: assigns each point to its nearest primitive, merges pairs, and
// drops primitives whose points others explain too.
#pragma once

#include <vector>

#include "primitives/region.h"

namespace prehend {

// The objective of a set of primitives (see Surface): lower is better.
double objective(const std::vector<Region>& regions, const Surface& surface);

// Repeats while the objective falls; never returns a worse set, nor an empty one.
std::vector<Region> polished(std::vector<Region> regions, const Surface& surface);

// Removes the primitives that cost least until at most `count` (>= 1) remain.
std::vector<Region> reduced(std::vector<Region> regions, const Surface& surface, std::size_t count);

}  // namespace prehend
