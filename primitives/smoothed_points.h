// Points of a surface as it is without the roughness of scans and of coarse triangles.
#pragma once

#include <cstddef>
#include <vector>

#include "primitives/surface_sample.h"

namespace prehend {

struct SmoothedPoints {
  std::vector<SurfacePoint> smooth;  // as far from noise as it gets; inside of what is curved
  std::vector<SurfacePoint> exact;   // the same points where they were sampled, for exact sizes
};

// About `count` of the points. The smooth ones are moved along the normal onto the weighted mean of
// those within `radius` [in the unit of the points] that face the same way; the normal of both is
// the mean of theirs. Noise crumples a surface: its area grows and its triangles face anywhere, but
// the mean of their normals, weighted with area, hardly changes, because the integral of the normal
// over a patch depends on the patch's border only. So each point that is kept stands for the same
// area of the smooth surface, not of the crumpled one. The two sides of a wall do not mix. The same
// result on any number of threads (0: one per processor).
SmoothedPoints smoothed_points(const std::vector<SurfacePoint>& points, double radius,
                               std::size_t count, int threads = 1);

}  // namespace prehend
