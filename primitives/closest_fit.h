// The last fit of a primitive: as close to its points as it gets.
#pragma once

#include <span>

#include "primitives/surface_sample.h"
#include "sim/shape/primitive.h"

namespace prehend {

// The primitive near `start` with the least squared distances from those of the points (at least
// one) that it explains, all of its numbers together (Levenberg-Marquardt; Marquardt 1963). Points
// count less and less the farther they are (Tukey's biweight), with a cutoff that shrinks from
// `tolerance` [m] with the median distance of those that count: a handle then does not tilt the
// body of a cup that is round up to its tessellation, while a rough body keeps all of its points.
// What the points do not determine, such as an open end, stays as it was; no shift or size
// changes by more than 0.1 (of the unit mesh), no turn by more than 0.2 rad.
// benchmarks/results/primitives.md compares methods of NLopt.
Primitive closest_fit(const Primitive& start, std::span<const SurfacePoint> points,
                      double tolerance);

}  // namespace prehend
