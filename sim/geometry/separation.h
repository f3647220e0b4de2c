// A fast and reliable lower bound of the distance between two convex sets of points.
#pragma once

#include <span>
#include <vector>

#include "sim/base/pose.h"

namespace prehend {

// A convex set [m]: all points within `margin` of the convex hull of `points` (not empty). It is
// represented by its support function, which asks for the point that lies farthest along a
// direction.
struct ConvexPoints {
  std::vector<Vector3> points;
  double margin = 0.0;
};

// A lower bound of the distance [m] between the sets a and b: the largest value found of min_b n.b
// - max_a n.a over unit directions n. This is a lower bound for every n, so that rounding errors of
// the search cannot invalidate it. <= 0 when the sets intersect or no separating direction was
// found. The directions come from GJK (Gilbert, Johnson and Keerthi 1988), stopped when the bound
// reaches 90 % of the distance of the hulls. `direction` (in a's frame, of any length) is the
// direction to start with; on return it is the best one found, a good start for a similar query.
// X_AB: pose of b's frame in a's frame.
double separation(const ConvexPoints& a, const ConvexPoints& b, const Pose& X_AB,
                  Vector3& direction);

}  // namespace prehend
