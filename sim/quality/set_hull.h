// The hull of a convex set that is known by its support function only: facets and volume.
#pragma once

#include "sim/quality/point_hull.h"
#include "sim/quality/support.h"

namespace prehend {

struct SetHullOptions {
  // A facet is final when the set reaches beyond it by at most this part of the set's size, > 0.
  double relative_tolerance = 1e-9;
  // Points after which no more are asked for: what is known by then is the answer.
  int max_points = 500;
};

// The hull of points of the set: inside of it, and equal to it up to the tolerance when `complete`.
struct SetHull {
  bool complete = false;
  PointHull hull;
  // The volume of the set lies between these: the hull's, and that of the pyramids over its facets
  // enlarged until they contain the set.
  double volume_lower = 0.0;
  double volume_upper = 0.0;
};

// Grows by the points that the set has beyond the facets, round after round. A flat set has a flat
// hull and no volume. Throws InputError where the tolerance is not positive, and
// std::runtime_error with qhull's message where qhull fails.
SetHull set_hull(const SupportMap& set, const SetHullOptions& options = {});

}  // namespace prehend
