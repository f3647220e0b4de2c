// Cylinders whose side tapers become cones.
#pragma once

#include <span>

#include "primitives/surface_sample.h"
#include "sim/shape/primitive.h"

namespace prehend {

// The cone about the axis and between the ends of a cylinder that was fitted to these points, if it
// explains them clearly better (misfit() at most 0.7 of the cylinder's) and its radii differ by
// at least 15 % of their mean; else the primitive as it is, as for other shapes. `tolerance` as in
// misfit() [in the unit of the points].
Primitive tapered(const Primitive& primitive, std::span<const SurfacePoint> points,
                  double tolerance);

}  // namespace prehend
