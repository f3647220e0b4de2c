// The volume of a convex hull from its facets, with a proof that they are the right ones.
#pragma once

#include <optional>

#include "sim/quality/point_hull.h"
#include "sim/quality/wrench.h"

namespace prehend {

// The volume inside the facets of `hull` (normals, offsets and corners; six dimensions) if it is
// proved, independently of how they were found, that they are those of the convex hull of the
// columns of `wrenches`:
// - no column is above the plane of a facet, and no corner of a facet below it, by more than 2e-11
//   of the largest coordinate. Together these errors change the volume by at most 1e-8 of it;
// - the area vectors of the facets (area times normal) add up to zero, as those of any closed
//   surface do (Minkowski 1903). Where facets are missing, or fold over others, they do not, save
//   by a coincidence of areas.
// Nothing otherwise, also where the volume is not a normal double: no answer, and no statement
// about the wrenches.
std::optional<double> proved_volume(const Wrenches& wrenches, const PointHull& hull);

}  // namespace prehend
