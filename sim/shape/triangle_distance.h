// The distance between two triangles.
#pragma once

#include <array>

#include "sim/base/pose.h"

namespace prehend {

// A triangle with what its distance queries need [m].
struct PlacedTriangle {
  std::array<Vector3, 3> corner;
  // Unit; zero for a triangle so thin that its normal is not reliable. Such a triangle is taken for
  // its edges.
  Vector3 normal = Vector3::Zero();
};

// The normal for PlacedTriangle.
Vector3 reliable_normal(const std::array<Vector3, 3>& corners);

// How far the plane of one triangle is from the corners of the other, the larger of both ways [m]:
// a lower bound of the distance in a fraction of its time. 0 where both planes have corners on both
// sides.
double plane_bound(const PlacedTriangle& u, const PlacedTriangle& v);

// The distance [m] and the nearest points, `on_u` and `on_v`. 0 where the triangles touch or
// intersect; the points are then not meaningful.
struct NearestPoints {
  double distance = 0.0;
  Vector3 on_u = Vector3::Zero();
  Vector3 on_v = Vector3::Zero();
};

// Exact up to rounding. The nearest points are a corner and a point of the other's face, or are on
// two edges (Larsen, Gottschalk, Lin and Manocha 1999).
NearestPoints triangle_distance(const PlacedTriangle& u, const PlacedTriangle& v);

}  // namespace prehend
