// The full convex hull of wrenches by qhull: the oracle for epsilon, and the volume.
#pragma once

#include <string>

#include "sim/quality/wrench.h"

namespace prehend {

enum class HullStatus {
  solid,  // a hull with volume
  flat,   // the wrenches do not span six dimensions: no volume, no force closure
};

struct WrenchHull {
  HullStatus status = HullStatus::flat;
  double min_offset = 0.0;  // smallest signed facet offset: negative when the origin is outside
  double volume = 0.0;      // of the 6-D hull
  Wrench weakest = Wrench::Zero();  // -min_offset * unit normal of that facet (solid only)

  bool force_closure() const { return status == HullStatus::solid && min_offset > 0.0; }
};

// Thread-safe (one qhull state a call). Throws std::invalid_argument on a value that is not finite,
// std::runtime_error (with qhull's message) where qhull fails for another reason than flatness.
WrenchHull wrench_hull(const Wrenches& wrenches);

}  // namespace prehend
