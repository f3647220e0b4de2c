#include "sim/shape/contact/triangle_overlap.h"

#include <algorithm>

namespace prehend {

Corners moved(const Corners& corners, const Pose& X) {
  return {X * corners[0], X * corners[1], X * corners[2]};
}

Vector3 unit_normal(const Corners& corners) {
  return (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
}

// Sutherland and Hodgman's polygon clipping against one plane. Corners on the plane are kept; an
// edge that crosses it from one side to the other adds the crossing point.
void cut(Polygon& polygon, const Vector3& a, const Vector3& inward) {
  std::array<double, Polygon::kMost> inside;
  double least = 0.0;
  for (std::size_t i = 0; i < polygon.size; ++i) {
    inside[i] = (polygon.corner[i] - a).dot(inward);
    least = std::min(least, inside[i]);
  }
  if (least == 0.0) return;
  Polygon rest;
  for (std::size_t i = 0; i < polygon.size; ++i) {
    const std::size_t next = (i + 1) % polygon.size;
    const Vector3& p = polygon.corner[i];
    const Vector3& q = polygon.corner[next];
    const double dp = inside[i];
    const double dq = inside[next];
    if (dp >= 0.0) rest.push(p);
    if ((dp > 0.0 && dq < 0.0) || (dp < 0.0 && dq > 0.0)) rest.push(p + (dp / (dp - dq)) * (q - p));
  }
  polygon = rest;
}

// Clips the triangle to the infinite prism over the face, which is bounded by the planes through
// the edges of the face along its normal. For an edge in counter-clockwise order, normal x edge
// points into the prism. Parts below the face are kept as well. Most triangles are beside one of
// the planes with all of their corners, or within it.
Polygon over_face(const Corners& face, const Vector3& normal, const Corners& other) {
  Polygon polygon;
  Corners inward;
  std::array<int, 3> outside{};  // how many corners are beside the plane
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3 edge = face[(k + 1) % 3] - face[k];
    inward[k] = normal.cross(edge);  // its length changes nothing
    for (const Vector3& p : other) outside[k] += (p - face[k]).dot(inward[k]) < 0.0 ? 1 : 0;
    if (outside[k] == 3) return polygon;
  }
  for (const Vector3& p : other) polygon.push(p);
  for (std::size_t k = 0; k < 3; ++k) {
    if (outside[k] > 0) cut(polygon, face[k], inward[k]);
  }
  return polygon;
}

}  // namespace prehend
