#include "sim/shape/primitive.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace prehend {
namespace {

using std::numbers::pi;

// By symmetry only the octant of positive coordinates matters, where `beyond` holds the signed
// distances from the planes of the three faces. Outside the box, the distance is the length of the
// positive parts of `beyond`; inside, it is minus the distance to the nearest face. One of the two
// terms is always zero. A cylinder is computed alike in the half plane (distance from the axis,
// |z|), where it is a rectangle.
double distance_to(const Box& box, const Vector3& p) {
  const Vector3 beyond = p.cwiseAbs() - 0.5 * box.size;
  const double inside = std::min(beyond.maxCoeff(), 0.0);
  return beyond.cwiseMax(0.0).norm() + inside;
}

double distance_to(const Sphere& sphere, const Vector3& p) { return p.norm() - sphere.radius; }

// Not std::hypot: it takes care of squares that overflow, which lengths of objects are far from,
// and is several times slower.
double distance_to(const Cylinder& cylinder, const Vector3& p) {
  const double side = p.head<2>().norm() - cylinder.radius;
  const double end = std::abs(p.z()) - 0.5 * cylinder.height;
  const double inside = std::min(std::max(side, end), 0.0);
  return Eigen::Vector2d(std::max(side, 0.0), std::max(end, 0.0)).norm() + inside;
}

double distance_to_segment(const Vector3& a, const Vector3& b, const Vector3& p) {
  const Vector3 along = b - a;
  const double length = along.squaredNorm();
  const double part = length > 0.0 ? std::clamp(along.dot(p - a) / length, 0.0, 1.0) : 0.0;
  return (a + part * along - p).norm();
}

// In the half plane (distance from the axis, z) a cone is a trapezium.
double distance_to(const Cone& cone, const Vector3& p) {
  const double half = 0.5 * cone.height;
  const Vector3 at(p.head<2>().norm(), 0.0, p.z());
  const Vector3 low(cone.radius_low, 0.0, -half);
  const Vector3 high(cone.radius_high, 0.0, half);
  const Vector3 side = high - low;
  const Vector3 outward = Vector3(side.z(), 0.0, -side.x()).normalized();
  const double beyond = std::max({outward.dot(at - low), at.z() - half, -half - at.z()});
  const double to_surface =
      std::min({distance_to_segment(low, high, at), distance_to_segment(low, {0.0, 0.0, -half}, at),
                distance_to_segment(high, {0.0, 0.0, half}, at)});
  return beyond > 0.0 ? to_surface : -to_surface;
}

double distance_to_curve(const std::vector<Vector3>& points, bool closed, const Vector3& p) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    nearest = std::min(nearest, distance_to_segment(points[i], points[i + 1], p));
  }
  if (closed && !points.empty()) {
    nearest = std::min(nearest, distance_to_segment(points.back(), points.front(), p));
  }
  return nearest;
}

double distance_to(const Rim& rim, const Vector3& p) {
  return distance_to_curve(points_of(rim), rim.closed, p) - 0.5 * rim.width;
}

double distance_to(const Bar& bar, const Vector3& p) {
  return distance_to_curve(bar.points, bar.closed, p) - 0.5 * bar.width;
}

double area_of(const Box& box) {
  const Vector3& s = box.size;
  return 2.0 * (s.x() * s.y() + s.y() * s.z() + s.z() * s.x());
}

double area_of(const Sphere& sphere) { return 4.0 * pi * sphere.radius * sphere.radius; }

double area_of(const Cylinder& cylinder) {
  return 2.0 * pi * cylinder.radius * (cylinder.radius + cylinder.height);
}

double area_of(const Cone& cone) {
  const double low = cone.radius_low;
  const double high = cone.radius_high;
  return pi * (low * low + high * high + (low + high) * std::hypot(cone.height, low - high));
}

double area_of(const Rim& rim) { return pi * rim.width * curve_length(points_of(rim), rim.closed); }

double area_of(const Bar& bar) { return pi * bar.width * curve_length(bar.points, bar.closed); }

std::string_view name_of(const Box&) { return "box"; }
std::string_view name_of(const Sphere&) { return "sphere"; }
std::string_view name_of(const Cylinder&) { return "cylinder"; }
std::string_view name_of(const Cone&) { return "cone"; }
std::string_view name_of(const Rim&) { return "rim"; }
std::string_view name_of(const Bar&) { return "bar"; }

}  // namespace

std::string_view shape_name(const Shape& shape) {
  return std::visit([](const auto& s) { return name_of(s); }, shape);
}

bool is_curve(const Shape& shape) {
  return std::holds_alternative<Rim>(shape) || std::holds_alternative<Bar>(shape);
}

double signed_distance(const Primitive& primitive, const Vector3& p_O) {
  // Inverse of a rigid transform: the transposed rotation.
  const Vector3 p_P = primitive.X_OP.linear().transpose() * (p_O - primitive.X_OP.translation());
  return std::visit([&p_P](const auto& s) { return distance_to(s, p_P); }, primitive.shape);
}

double surface_area(const Shape& shape) {
  return std::visit([](const auto& s) { return area_of(s); }, shape);
}

double curve_length(const std::vector<Vector3>& points, bool closed) {
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) length += (points[i + 1] - points[i]).norm();
  if (closed && !points.empty()) length += (points.front() - points.back()).norm();
  return length;
}

std::vector<Vector3> points_of(const Rim& rim) {
  std::vector<Vector3> points;
  for (const RimPoint& at : rim.points) points.push_back(at.p);
  return points;
}

}  // namespace prehend
