// A hyperplane of wrench space that bounds a polytope: the set normal . x <= offset.
#pragma once

#include <array>

#include "sim/quality/wrench.h"

namespace prehend {

struct Hyperplane {
  Wrench normal = Wrench::Zero();  // unit
  double offset = 0.0;
};

// A plane and how well it passes through the corners of a facet.
struct FittedPlane {
  Hyperplane plane;     // every corner has normal . corner >= offset, at least one equality
  double spread = 0.0;  // largest normal . corner - offset
};

using FacetCorners = std::array<const Wrench*, 6>;

// The plane with the direction of `normal` (not zero), moved to the lowest of the corners. Because
// of that choice the distance from the origin to the simplex of the corners is at least `offset`,
// however inexact the normal is.
FittedPlane fit_offset(const Wrench& normal, const FacetCorners& corners);

// The plane through the corners, with its normal on the side of `guess` (not zero): `guess` less
// its components along the facet. Where a facet is so thin that its edges do not determine the
// normal, `guess` decides among those possible.
FittedPlane fit_plane(const Wrench& guess, const FacetCorners& corners);

}  // namespace prehend
