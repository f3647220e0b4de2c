#include "planner/show/picture/camera.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "sim/base/input_error.h"

namespace prehend {
namespace {

// A pinhole camera: a point (x, y, z) in the camera frame is seen at the pixel
// center + focal_length (x, y) / z. The focal length is in pixels, so that half of the picture's
// height is seen under half of the vertical field of view.

// Rows: the axes of the camera frame (right, down, forward) in the world. `forward` is unit.
Matrix3 camera_axes(const Vector3& forward, const Vector3& up) {
  constexpr double kParallel = 1e-9;
  Vector3 right = forward.cross(up);
  // Looking along `up`, there is no horizontal direction; any right will do.
  if (!(right.norm() > kParallel * up.norm())) right = any_orthogonal(forward);
  right.normalize();
  Matrix3 axes;
  axes << right.transpose(), forward.cross(right).transpose(), forward.transpose();
  return axes;
}

}  // namespace

Projection::Projection(const Camera& camera, int width, int height) {
  const Vector3 view = camera.target - camera.eye;
  const double distance = view.norm();
  if (!camera.eye.allFinite() || !camera.up.allFinite() || !std::isfinite(distance) ||
      !(distance > 0.0)) {
    throw InputError({.field = "camera.target",
                      .problem = "must be finite and apart from the eye",
                      .value = "distance " + std::to_string(distance)});
  }
  const double angle = camera.vertical_field_of_view;
  require(angle > 0.0 && angle < std::numbers::pi, {.field = "camera.vertical_field_of_view",
                                                    .problem = "must be in (0, pi)",
                                                    .value = std::to_string(angle)});
  // The near plane clips what is closer to the eye. It is near enough not to be noticed, and far
  // enough that pixel coordinates, which grow with 1 / depth, stay moderate numbers.
  constexpr double kNearPerDistance = 1e-3;
  const Matrix3 R_CW = camera_axes(view / distance, camera.up);
  X_CW_ = pose_from(R_CW, -(R_CW * camera.eye));
  center_ = 0.5 * Eigen::Vector2d(width, height);
  focal_length_ = 0.5 * height / std::tan(0.5 * angle);
  near_depth_ = kNearPerDistance * distance;
}

Eigen::Vector2d Projection::pixel(const Vector3& p_C) const {
  return center_ + (focal_length_ / p_C.z()) * p_C.head<2>();
}

Vector3 Projection::line_of_sight(const Eigen::Vector2d& pixel) const {
  const Eigen::Vector2d across = (pixel - center_) / focal_length_;
  return {across.x(), across.y(), 1.0};
}

Camera camera_around(const std::vector<Vector3>& points, const Vector3& direction, int width,
                     int height) {
  const double norm = direction.norm();
  require(std::isfinite(norm) && norm > 0.0, {.field = "direction",
                                              .problem = "must be finite and not zero",
                                              .value = "length " + std::to_string(norm)});
  require(!points.empty(), {.field = "points", .problem = "there is nothing to look at"});
  constexpr double kAlongZ = 0.999;
  constexpr double kUsedPart = 0.9;     // of the picture: a margin of 5 % on each side
  constexpr double kLeastDepth = 1e-3;  // for points that are one
  const Vector3 backward = direction / norm;
  Camera camera;
  // Near the z axis, z as up would let the picture turn by a large angle for a small change of the
  // direction.
  if (std::abs(backward.z()) > kAlongZ) camera.up = Vector3::UnitY();
  const Matrix3 axes = camera_axes(-backward, camera.up);
  Eigen::Vector2d slope;  // of the four planes that bound the view, against the line of sight
  slope.y() = kUsedPart * std::tan(0.5 * camera.vertical_field_of_view);
  slope.x() = slope.y() * width / height;

  // The eye is placed exactly, without iteration. Along x and y apart, with the eye at (e, -d) in
  // axes through the first point, a point (p, z) is inside the view when |p - e| <= slope (z + d),
  // that is slope d >= (p - slope z) - e and slope d >= (-p - slope z) + e. `high` and `low` are
  // the largest of the two brackets over all points. The smallest d that meets slope d >= high - e
  // and slope d >= low + e has both equal: e = (high - low) / 2, slope d = (high + low) / 2. The
  // larger d of x and y is taken.
  Eigen::Vector2d low = Eigen::Vector2d::Constant(-std::numeric_limits<double>::infinity());
  Eigen::Vector2d high = low;
  Vector3 least = Vector3::Constant(std::numeric_limits<double>::infinity());
  Vector3 most = -least;
  for (const Vector3& p : points) {
    if (!p.allFinite()) throw InputError({.field = "points", .problem = "must be finite"});
    const Vector3 q = axes * (p - points.front());
    low = low.cwiseMax(-q.head<2>() - slope * q.z());
    high = high.cwiseMax(q.head<2>() - slope * q.z());
    least = least.cwiseMin(q);
    most = most.cwiseMax(q);
  }
  // The eye also stays clear of the nearest point, which a single point or a line of points seen
  // end-on would not demand by themselves.
  const double clearance = std::max(0.25 * (most - least).norm(), kLeastDepth);
  const double distance =
      std::max((0.5 * (low + high)).cwiseQuotient(slope).maxCoeff(), clearance - least.z());
  const Eigen::Vector2d aside = 0.5 * (high - low);
  const double middle = 0.5 * (least.z() + most.z());
  camera.eye = points.front() + axes.transpose() * Vector3(aside.x(), aside.y(), -distance);
  camera.target = points.front() + axes.transpose() * Vector3(aside.x(), aside.y(), middle);
  return camera;
}

Camera camera_around(const Bounds& box, const Vector3& direction, int width, int height) {
  require((box.lower.array() <= box.upper.array()).all(),
          {.field = "box",
           .problem = "must not be empty",
           .value = "diagonal " + std::to_string(box.diagonal())});
  std::vector<Vector3> corners;
  for (int corner = 0; corner < 8; ++corner) {
    Vector3 p = box.lower;
    for (int k = 0; k < 3; ++k) {
      if (((corner >> k) & 1) != 0) p[k] = box.upper[k];
    }
    corners.push_back(p);
  }
  return camera_around(corners, direction, width, height);
}

}  // namespace prehend
