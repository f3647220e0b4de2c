#include "planner/plan/learn/primitive_extent.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace prehend {
namespace {

// The direction `d` is in the primitive's frame.

double across_axis(const Vector3& d) { return std::hypot(d.x(), d.y()); }

double extent_of(const Box& box, const Vector3& d) { return box.size.dot(d.cwiseAbs()); }

double extent_of(const Sphere& sphere, const Vector3& /*d*/) { return 2.0 * sphere.radius; }

double extent_of(const Cylinder& cylinder, const Vector3& d) {
  return 2.0 * cylinder.radius * across_axis(d) + cylinder.height * std::abs(d.z());
}

// The extreme points are on the edges of the two ends.
double extent_of(const Cone& cone, const Vector3& d) {
  const double low = -0.5 * cone.height * d.z();
  const double high = -low;
  const double side = across_axis(d);
  return std::max(low + cone.radius_low * side, high + cone.radius_high * side) -
         std::min(low - cone.radius_low * side, high - cone.radius_high * side);
}

double extent_of_points(const std::vector<Vector3>& points, const Vector3& d, double width) {
  if (points.empty()) return width;
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  for (const Vector3& p : points) {
    least = std::min(least, d.dot(p));
    most = std::max(most, d.dot(p));
  }
  return most - least + width;
}

double extent_of(const Rim& rim, const Vector3& d) {
  return extent_of_points(points_of(rim), d, rim.width);
}

double extent_of(const Bar& bar, const Vector3& d) {
  return extent_of_points(bar.points, d, bar.width);
}

}  // namespace

double primitive_extent(const Primitive& primitive, const Vector3& direction_O) {
  const Vector3 d = primitive.X_OP.linear().transpose() * direction_O;
  return std::visit([&](const auto& shape) { return extent_of(shape, d); }, primitive.shape);
}

}  // namespace prehend
