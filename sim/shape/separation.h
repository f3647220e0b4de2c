// A fast and reliable lower bound of the distance between two convex sets of points.
#pragma once

#include <vector>

#include "sim/base/pose.h"

namespace prehend {

// A convex set [m]: all points within `margin` of the convex hull of `points` (not empty). It is
// represented by its support function, which asks for the point that lies farthest along a
// direction.
class ConvexPoints {
 public:
  // Copies of the coordinates are kept in single precision and in blocks, for the search.
  explicit ConvexPoints(std::vector<Vector3> points, double margin = 0.0);

  const std::vector<Vector3>& points() const { return points_; }
  double margin() const { return margin_; }

  // A point that lies farthest along the unit `direction`, up to search_error().
  const Vector3& farthest(const Vector3& direction) const;
  // At most about a millionth of the size of the set [m]: single precision decides between points
  // that lie equally far.
  double search_error() const { return search_error_; }

 private:
  std::vector<Vector3> points_;
  double margin_ = 0.0;
  double search_error_ = 0.0;
  std::vector<float> blocks_;  // coordinates from the centre: 8 times x, 8 times y, 8 times z, ...
};

// A lower bound of the distance [m] between the sets a and b: the largest value found of min_b n.b
// - max_a n.a over unit directions n, less the search errors of both. This is a lower bound for
// every n, so that rounding errors of the search cannot invalidate it. <= 0 when the sets intersect
// or no separating direction was found. The directions come from GJK (Gilbert, Johnson and Keerthi
// 1988), stopped when the bound reaches 90 % of the distance of the hulls. `direction` (in a's
// frame, of any length) is the direction to start with; on return it is the best one found, a good
// start for a similar query. X_AB: pose of b's frame in a's frame.
double separation(const ConvexPoints& a, const ConvexPoints& b, const Pose& X_AB,
                  Vector3& direction);

}  // namespace prehend
