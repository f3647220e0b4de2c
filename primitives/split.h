// One piece of surface into two, where that explains it best.
#pragma once

#include <optional>

#include "primitives/region.h"

namespace prehend {

struct Split {
  Region first;
  Region second;

  double cost() const { return first.cost + second.cost; }
};

// The cheapest of: cuts by planes across the principal axes, and the region's own primitive's
// explained points against the rest. Nothing when the region is too small to cut.
std::optional<Split> best_split(const Region& region, const Surface& surface);

}  // namespace prehend
