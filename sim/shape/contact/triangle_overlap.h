// The part of one triangle that lies above another, seen along its normal.
#pragma once

#include <array>

#include "sim/base/pose.h"
#include "sim/shape/triangle_mesh.h"

namespace prehend {

// The corners with the pose X applied to each.
Corners moved(const Corners& corners, const Pose& X);
// The triangle's unit normal by the right-hand rule, outward for the triangles of a closed mesh. Of
// no meaning for a triangle without area.
Vector3 unit_normal(const Corners& corners);

// A planar convex polygon: a triangle cut by up to five half-spaces, each of which adds at most one
// corner to its three.
struct Polygon {
  static constexpr std::size_t kMost = 8;
  std::array<Vector3, kMost> corner;
  std::size_t size = 0;
  void push(const Vector3& p) {
    if (size < corner.size()) corner[size++] = p;
  }
};

// Leaves of the polygon what is on the side of the plane through `a` that `inward` points to.
void cut(Polygon& polygon, const Vector3& a, const Vector3& inward);

// The part of `other` whose projection along the face's unit normal falls on the face.
Polygon over_face(const Corners& face, const Vector3& normal, const Corners& other);

}  // namespace prehend
