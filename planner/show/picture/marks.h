// Arrows and cones as closed meshes, for showing forces and contacts in a picture.
#pragma once

#include "sim/shape/triangle_mesh.h"

namespace prehend {

// Of the polygon that stands for a circle.
inline constexpr int kRoundSides = 32;

// A round shaft of `radius` with a head that ends at `to`, in the frame of the arguments. The head
// takes at most half the length. Empty when the points coincide or `radius` is not positive.
TriangleMesh arrow_mesh(const Vector3& from, const Vector3& to, double radius);

// The set {apex + t u + w : 0 <= t <= length, w orthogonal to u, |w| <= slope t} with u along
// `axis` (any length): half angle atan(slope), so slope = mu for a friction cone. The round is a
// polygon of `sides` (>= 3) inscribed in the circle. Empty when the set has no volume.
TriangleMesh cone_mesh(const Vector3& apex, const Vector3& axis, double slope, double length,
                       int sides = kRoundSides);

}  // namespace prehend
