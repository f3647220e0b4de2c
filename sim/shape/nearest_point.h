// The point of a triangle nearest to a given point.
#pragma once

#include <array>

#include "sim/base/pose.h"

namespace prehend {

// All in one frame. Also for a triangle without area.
Vector3 nearest_point_on(const std::array<Vector3, 3>& triangle, const Vector3& p);

}  // namespace prehend
