// A cheap, certain lower bound of the distance between two convex sets of points.
#pragma once

#include <span>
#include <vector>

#include "sim/base/pose.h"

namespace prehend {

// The convex hull of `points`, known by its support function.
struct ConvexPoints {
  std::vector<Vector3> points;
};

// The largest value found of  min_b n.b - max_a n.a  over unit directions n: a lower bound of the
// distance between the hulls whatever n is, so that rounding cannot make it wrong; <= 0 when the
// hulls meet or no separating direction was found. Directions come from a few steps of GJK
// (Gilbert, Johnson and Keerthi 1988), which reach the distance itself to 10 %. `direction` (in a's
// frame, any vector) is where to start; it is left at the best direction found, the start for the
// next query. X_AB: the pose of b's frame in a's frame.
double separation(const ConvexPoints& a, const ConvexPoints& b, const Pose& X_AB,
                  Vector3& direction);

}  // namespace prehend
