#include "sim/shape/box_shape.h"

#include <algorithm>
#include <cmath>

#include "sim/shape/mesh_checks.h"

namespace prehend {
namespace {

// What counts as nothing: a part of the size, and of the volume.
constexpr double kBoxRounding = 1e-6;

// The normal of the largest face across `to`, or of the largest face for a zero vector.
std::optional<Vector3> largest_normal(const TriangleMesh& mesh, const Vector3& to) {
  Vector3 largest = Vector3::Zero();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vector3 area = doubled_area_vector(mesh, t);
    if (std::abs(area.dot(to)) > kBoxRounding * area.norm()) continue;
    if (area.norm() > (1.0 + kBoxRounding) * largest.norm()) largest = area;
  }
  if (!(largest.norm() > 0.0)) return std::nullopt;
  return largest.normalized();
}

}  // namespace

std::optional<PlacedBox> box_shape(const TriangleMesh& convex) {
  const auto x = largest_normal(convex, Vector3::Zero());
  if (!x) return std::nullopt;
  const auto y = largest_normal(convex, *x);
  if (!y) return std::nullopt;
  Matrix3 R;
  const Vector3 across = (*y - y->dot(*x) * *x).normalized();
  R << *x, across, x->cross(across);
  Bounds box;
  for (const Vector3& p : convex.vertices) {
    const Vector3 at = R.transpose() * p;
    box.lower = box.lower.cwiseMin(at);
    box.upper = box.upper.cwiseMax(at);
  }
  const double volume = box.size().prod();
  if (std::abs(signed_volume(convex) - volume) > kBoxRounding * volume) return std::nullopt;
  return PlacedBox{pose_from(R, R * box.center()), box.size()};
}

}  // namespace prehend
