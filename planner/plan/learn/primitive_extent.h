// How large a primitive is along a direction.
#pragma once

#include "sim/shape/primitive.h"

namespace prehend {

// The size [m] of the primitive along the unit vector `direction_O` (object frame): the difference
// between the largest and the smallest coordinate of its points. Of a curve, that of its points,
// plus its width.
double primitive_extent(const Primitive& primitive, const Vector3& direction_O);

}  // namespace prehend
