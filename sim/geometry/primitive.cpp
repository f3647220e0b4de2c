#include "sim/geometry/primitive.h"

#include <algorithm>
#include <cmath>
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

double area_of(const Box& box) {
  const Vector3& s = box.size;
  return 2.0 * (s.x() * s.y() + s.y() * s.z() + s.z() * s.x());
}

double area_of(const Sphere& sphere) { return 4.0 * pi * sphere.radius * sphere.radius; }

double area_of(const Cylinder& cylinder) {
  return 2.0 * pi * cylinder.radius * (cylinder.radius + cylinder.height);
}

std::string_view name_of(const Box&) { return "box"; }
std::string_view name_of(const Sphere&) { return "sphere"; }
std::string_view name_of(const Cylinder&) { return "cylinder"; }

}  // namespace

std::string_view shape_name(const Shape& shape) {
  return std::visit([](const auto& s) { return name_of(s); }, shape);
}

double signed_distance(const Primitive& primitive, const Vector3& p_O) {
  // Inverse of a rigid transform: the transposed rotation.
  const Vector3 p_P = primitive.X_OP.linear().transpose() * (p_O - primitive.X_OP.translation());
  return std::visit([&p_P](const auto& s) { return distance_to(s, p_P); }, primitive.shape);
}

double surface_area(const Shape& shape) {
  return std::visit([](const auto& s) { return area_of(s); }, shape);
}

}  // namespace prehend
