// The plane on which things stand, found in readings.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sim/shape/cloud/reconstruct.h"

namespace prehend {

struct FoundPlane {
  SupportPlane plane;
  Vector3 point_W = Vector3::Zero();  // on it, in the middle of what was seen of it
};

// Where the search of a support ended.
struct PlaneSearch {
  std::optional<FoundPlane> found = {};
  bool plane_only = false;  // nearly all readings are on one large plane
};

// The largest plane with readings above it, on the side of the first camera: RANSAC (Fischler and
// Bolles 1981) on three readings at a time, then least squares. Planes that are level in W are
// preferred to others up to twice their size. The surface around most readings on it must have its
// normal: readings of a ball are on planes, too. `noise` of a reading [m].
PlaneSearch find_support(const std::vector<DepthView>& views, double noise, std::uint64_t seed);

// Whether a point of W is above the outline of the plane, or less than `margin` [m] beside it.
bool above_outline(const SupportPlane& plane, const Vector3& p_W, double margin);

}  // namespace prehend
