// Cylinders, cones and spheres along one axis.
#pragma once

#include <vector>

#include "primitives/region.h"
#include "primitives/turn_profile.h"

namespace prehend {

struct CoaxialSolids {
  std::vector<Primitive> solids;  // from low to high
  double explained = 0.0;  // share of the whole surface, less the misfit of what they explain
  // `explained` less the prices of the solids.
  double gain = 0.0;
};

// The solids of least total cost for a profile, in a frame where the object's bounding box has a
// diagonal of 1. Each step of the profile is explained by one solid, or by none, which costs its
// share of the surface. A solid costs the squared distances of the radii that it explains, a fixed
// price, more where it has more numbers than a cylinder, and of a sphere what of it the profile
// does not have. The best of all divisions of the axis, by dynamic programming (Bellman 1961, "On
// the approximation of curves by line segments using dynamic programming"). `area`: of the whole
// surface; `tolerance`: a radius that is so far off costs as much as if nothing explained it.
CoaxialSolids best_coaxial_solids(const TurnAxis& axis, const TurnProfile& profile, double area,
                                  double tolerance);

// The regions of the surface that coaxial solids explain well: first of the axis about which most
// of it turns, then of the next, as long as they gain much. Their points, and those inside of them,
// such as of the inside of a cup, are taken out of `surface`.
std::vector<Region> take_coaxial_solids(Surface& surface);

}  // namespace prehend
