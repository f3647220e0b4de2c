// Unit vectors that cover the sphere evenly.
#pragma once

#include <vector>

#include "sim/base/pose.h"

namespace prehend {

// Direction i of n of a Fibonacci spiral over the sphere: equal steps along z, which have equal
// areas, and a turn by the golden angle from each to the next, which leaves none in line with an
// earlier one.
Vector3 sphere_direction(int i, int n);

// n directions of such a spiral over the half of the sphere with z > 0.
std::vector<Vector3> half_sphere_directions(int n);

}  // namespace prehend
