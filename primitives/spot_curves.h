// Lines up scattered spots into curves.
#pragma once

#include <vector>

#include "primitives/wall_spots.h"

namespace prehend {

// Places along a curve through spots, each at another point than the one before.
struct SpotCurve {
  std::vector<ThinSpot> places;  // at least two; directions are continuous from one to the next
  double length = 0.0;           // [m]
  bool closed = false;
};

// Spots nearer than `link` [m] with about the same direction and width are on the same curve. One
// whose spots go all the way around their middle is closed. Curves shorter than `shortest` [m] or
// of fewer than six spots are left out; the longest come first. O(n^2) for n spots.
std::vector<SpotCurve> spot_curves(const std::vector<ThinSpot>& spots, double link,
                                   double shortest);

}  // namespace prehend
