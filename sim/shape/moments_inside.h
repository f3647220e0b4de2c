// Exact integrals over the part of a solid that is in a convex region.
#pragma once

#include "sim/shape/convex_region.h"
#include "sim/shape/moments.h"

namespace prehend {

// The moments, about the origin, of what the solid and the region have in common. `surface` is
// closed: every edge is traversed equally often in both directions. Exact but for rounding; zero
// where the two have (next to) nothing in common.
//
// Seen from a point o of the region, the solid is a sum of signed tetrahedra, one behind each of
// its triangles. The region cuts each of them where the ray from o leaves it, and x/r(x) is that
// place, where r(x), the largest of the ratios n_j.(x - o) / (d_j - n_j.o), is above 1. The ratios
// are linear: they divide the triangle into polygons, one inside the region and one for each plane
// that is met first, whose images on that plane are polygons again.
Moments moments_inside(const TriangleMesh& surface, const ConvexRegion& region);

}  // namespace prehend
