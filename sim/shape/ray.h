// Where a ray first meets a mesh.
#pragma once

#include <limits>
#include <vector>

#include "sim/base/pose.h"

namespace prehend {

struct PlacedTriangle;  // triangle_distance.h
struct WideTree;        // wide_tree.h

// The first triangle on a ray, from either side; -1: none within the cap.
struct RayHit {
  double distance = std::numeric_limits<double>::infinity();  // from the origin of the ray [m]
  int triangle = -1;
};

// `from` and the unit vector `direction` in the frame of the mesh. Triangles that are farther than
// `cap` [m] are not looked at. `tree` is that of these triangles. A ray through an edge or a corner
// meets one of the triangles there, or, by rounding, none of them.
RayHit first_hit(const WideTree& tree, const std::vector<PlacedTriangle>& triangles,
                 const Vector3& from, const Vector3& direction, double cap);

}  // namespace prehend
