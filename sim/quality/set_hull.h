// A polytope that approximates a convex set known by its support function only, with bounds of the
// set's volume.
#pragma once

#include "sim/base/settings.h"
#include "sim/quality/point_hull.h"
#include "sim/quality/support.h"

namespace prehend {

struct SetHullOptions {
  static constexpr AboutSettings kAbout{"SetHullOptions", "How closely the volume is bracketed."};
  double relative_tolerance = 1e-9;
  int max_points = 500;
  // A hull of n points in six dimensions can have n^3 facets. 30,000 take some hundredths of a
  // second, or about a second where qhull has to be asked.
  int max_facets = 30000;
};

template <SettingsOf<SetHullOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [relative_tolerance, max_points, max_facets] = options;
  visit("relative_tolerance", relative_tolerance, kRatioAbove0, "",
        "A facet is final when the set reaches beyond it by at most this part of its largest "
        "coordinate.");
  visit("max_points", max_points, kCount, "",
        "Points after which the hull of these points is returned.");
  visit("max_facets", max_facets, kCount, "",
        "No points are added that would probably give the hull more facets than this.");
}

// The hull of points of the set. It lies inside the set.
struct SetHull {
  bool complete = false;  // whether every facet is final
  PointHull hull;         // of points in six dimensions
  // Bounds of the set's volume: below, the volume of the hull; above, that of the pyramids over its
  // facets, enlarged until together they contain the set, or of the box around the set.
  double volume_lower = 0.0;
  double volume_upper = 0.0;
};

// Approximates the set from inside: round after round, the set's support points along the normals
// of the hull's facets are added. A set that does not span six dimensions has a flat hull and no
// volume. Where qhull fails on the points of a round, the hull of the round before is returned; in
// the first round that is a hull whose status is `failed`, and the bounds are the volumes of a
// simplex inside the set and of the box around it. Throws InputError where the tolerance is not
// positive.
SetHull set_hull(const SupportMap& set, const SetHullOptions& options = {});

}  // namespace prehend
