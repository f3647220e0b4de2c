// A cylinder of any orientation around surface points.
#pragma once

#include "primitives/fit.h"

namespace prehend {

// Each point pulls the side or the cap it is nearest to; axis, radius and both caps are found
// together by robust Gauss-Newton, from the best of many starting axes. A cap that the points do
// not cover (a cup's open end) is put where the side ends.
// Requires at least one point.
Primitive fit_cylinder(std::span<const SurfacePoint> points, const FitOptions& options);

}  // namespace prehend
