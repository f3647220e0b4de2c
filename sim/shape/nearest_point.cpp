#include "sim/shape/nearest_point.h"

#include <algorithm>

namespace prehend {
namespace {

Vector3 nearest_point_on_segment(const Vector3& a, const Vector3& b, const Vector3& p) {
  const Vector3 ab = b - a;
  const double length = ab.squaredNorm();
  return length > 0.0 ? a + std::clamp((p - a).dot(ab) / length, 0.0, 1.0) * ab : a;
}

}  // namespace

// The foot of the perpendicular where it is inside the triangle, else the nearest point of the
// edges.
Vector3 nearest_point_on(const std::array<Vector3, 3>& triangle, const Vector3& p) {
  const Vector3 normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]).normalized();
  const Vector3 foot = p - (p - triangle[0]).dot(normal) * normal;
  bool inside = normal.squaredNorm() > 0.0;
  Vector3 nearest = triangle[0];
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3& a = triangle[k];
    const Vector3& b = triangle[(k + 1) % 3];
    inside = inside && (b - a).cross(foot - a).dot(normal) >= 0.0;
    const Vector3 on_edge = nearest_point_on_segment(a, b, p);
    if ((on_edge - p).squaredNorm() < (nearest - p).squaredNorm()) nearest = on_edge;
  }
  return inside ? foot : nearest;
}

}  // namespace prehend
