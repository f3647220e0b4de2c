// A box of any orientation around surface points.
#pragma once

#include "primitives/fit.h"

namespace prehend {

// Each point pulls the face it is nearest to; three angles and six face positions are found
// together by robust Gauss-Newton, from the best of many starting frames. A face that the points
// do not cover (an open end, a cut) is put where the other faces end.
// Requires at least one point.
Primitive fit_box(std::span<const SurfacePoint> points, const FitOptions& options);

}  // namespace prehend
