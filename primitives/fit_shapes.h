// The fits of one shape of each kind to surface points.
#pragma once

#include "primitives/fit.h"

namespace prehend {

// Each fit requires at least one point. None of them says how well the shape fits: misfit() does.

// A box of any orientation. Each point pulls the face it is nearest to; three angles and six face
// positions are found together by robust Gauss-Newton, from the best of many starting frames. A
// face that the points do not cover (an open end, a cut) is put where the other faces end.
Primitive fit_box(std::span<const SurfacePoint> points, const FitOptions& options);

// A cylinder of any orientation. Each point pulls the side or the cap it is nearest to; axis,
// radius and both caps are found together by robust Gauss-Newton, from the best of many starting
// axes. A cap that the points do not cover (a cup's open end) is put where the side ends.
Primitive fit_cylinder(std::span<const SurfacePoint> points, const FitOptions& options);

// A sphere. Minimises the robust sum of squared distances to it by Gauss-Newton, from an algebraic
// start (Pratt 1987, "Direct least-squares fitting of algebraic surfaces").
Primitive fit_sphere(std::span<const SurfacePoint> points, const FitOptions& options);

}  // namespace prehend
