#include "primitives/align.h"

#include <cmath>
#include <numbers>
#include <variant>

namespace prehend {
namespace {

// Above the error of fits to exact shapes, and so small that no point moves by what a grasp would
// notice.
constexpr double kNearlyParallel = 0.1 * std::numbers::pi / 180.0;

// A surface whose moments across the axis differ by less than this, relative to their sum, spreads
// alike in all directions.
constexpr double kLeastDifference = 0.01;

// The axis of the frame, with its sign, that is nearest to a unit direction.
Vector3 nearest_axis(const Vector3& direction) {
  int axis = 0;
  direction.cwiseAbs().maxCoeff(&axis);
  return std::copysign(1.0, direction[axis]) * Vector3::Unit(axis);
}

bool nearly_parallel(const Vector3& a, const Vector3& b) {
  return a.cross(b).norm() < std::sin(kNearlyParallel) && a.dot(b) > 0.0;
}

Matrix3 aligned_box(const Matrix3& rotation) {
  Matrix3 axes;
  for (int i = 0; i < 3; ++i) {
    axes.col(i) = nearest_axis(rotation.col(i));
    if (!nearly_parallel(rotation.col(i), axes.col(i))) return rotation;
  }
  return axes;
}

// The unit direction across z in which the surface spreads most, as seen from the line through
// `p_O` along z.
Vector3 widest_across(const Vector3& z, const Vector3& p_O, const SurfaceMoments& surface) {
  int axis = 0;
  z.cwiseAbs().minCoeff(&axis);
  const Vector3 u = (Vector3::Unit(axis) - z[axis] * z).normalized();
  const Vector3 v = z.cross(u);
  const Matrix3 about = surface.second - p_O * surface.first.transpose() -
                        surface.first * p_O.transpose() + surface.area * p_O * p_O.transpose();
  const double uu = u.dot(about * u);
  const double vv = v.dot(about * v);
  const double uv = u.dot(about * v);
  const double difference = std::hypot(uu - vv, 2.0 * uv);
  if (!(difference > kLeastDifference * (uu + vv))) return u;
  const double angle = 0.5 * std::atan2(2.0 * uv, uu - vv);
  return std::cos(angle) * u + std::sin(angle) * v;
}

// The frame with z along `axis` and x as near to `x` as that allows.
Matrix3 frame_along(const Vector3& axis, const Vector3& x) {
  Matrix3 axes;
  axes.col(2) = axis;
  axes.col(0) = (x - axis.dot(x) * axis).normalized();
  axes.col(1) = axes.col(2).cross(axes.col(0));
  return axes;
}

}  // namespace

// Over a triangle of area A with corners a, b, c and middle m, the integral of p p^T is
// A / 12 (a a^T + b b^T + c c^T + 9 m m^T).
SurfaceMoments surface_moments(const TriangleMesh& mesh) {
  SurfaceMoments moments;
  for (const Triangle& triangle : mesh.triangles) {
    const Vector3& a = mesh.vertices[static_cast<std::size_t>(triangle[0])];
    const Vector3& b = mesh.vertices[static_cast<std::size_t>(triangle[1])];
    const Vector3& c = mesh.vertices[static_cast<std::size_t>(triangle[2])];
    const double area = 0.5 * (b - a).cross(c - a).norm();
    const Vector3 middle = (a + b + c) / 3.0;
    moments.area += area;
    moments.first += area * middle;
    moments.second += area / 12.0 *
                      (a * a.transpose() + b * b.transpose() + c * c.transpose() +
                       9.0 * middle * middle.transpose());
  }
  return moments;
}

Primitive aligned(const Primitive& primitive, const SurfaceMoments& surface) {
  Primitive turned = primitive;
  if (std::holds_alternative<Cylinder>(primitive.shape)) {
    const Vector3 z = primitive.X_OP.linear().col(2);
    turned.X_OP.linear() = frame_along(z, widest_across(z, primitive.X_OP.translation(), surface));
  }
  return turned;
}

Primitive along_frame(const Primitive& primitive) {
  Primitive turned = primitive;
  const Matrix3 axes = primitive.X_OP.linear();
  if (std::holds_alternative<Box>(primitive.shape)) {
    turned.X_OP.linear() = aligned_box(axes);
  } else if (!std::holds_alternative<Sphere>(primitive.shape)) {
    const Vector3 z = nearest_axis(axes.col(2));
    if (nearly_parallel(axes.col(2), z)) turned.X_OP.linear() = frame_along(z, axes.col(0));
  }
  return turned;
}

}  // namespace prehend
