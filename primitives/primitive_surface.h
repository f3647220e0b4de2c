// Points spread over a primitive's own surface, to measure how much of it lies away from the mesh.
#pragma once

#include <vector>

#include "sim/shape/primitive.h"

namespace prehend {

// A point that represents a patch of a primitive's surface.
struct PatchPoint {
  Vector3 p_O = Vector3::Zero();
  double area = 0.0;  // the part of the primitive's surface that the point stands for
};

// About `count` points, evenly spread; their areas add up to surface_area(primitive.shape).
std::vector<PatchPoint> spread_points(const Primitive& primitive, int count);

}  // namespace prehend
