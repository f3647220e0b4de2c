// Splits a region of the surface into two, each with a primitive of its own.
#pragma once

#include <optional>

#include "primitives/region.h"

namespace prehend {

// The two parts of a region; every point is in one of them.
struct Split {
  Region first;
  Region second;

  double cost() const { return first.fit.cost + second.fit.cost; }
};

// The split of least cost among cuts by planes across the principal axes and the primitive's axes,
// and the separation of the points that the region's primitive explains from the rest. Nothing when
// the parts would be too small, or where quick fits tell that no split lowers the objective. The
// same on any number of threads. Throws Cancelled.
std::optional<Split> best_split(const Region& region, const Surface& surface);

}  // namespace prehend
