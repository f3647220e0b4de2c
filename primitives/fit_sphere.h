// A sphere through surface points.
#pragma once

#include "primitives/fit.h"

namespace prehend {

// Minimises the robust sum of squared distances to the sphere, from an algebraic start
// (Pratt 1987, "Direct least-squares fitting of algebraic surfaces") by Gauss-Newton.
// Requires at least one point.
Primitive fit_sphere(std::span<const SurfacePoint> points, const FitOptions& options);

}  // namespace prehend
