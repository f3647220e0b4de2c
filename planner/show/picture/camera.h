// A perspective camera and where it sees the points of the world.
#pragma once

#include <vector>

#include "sim/shape/triangle_mesh.h"

namespace prehend {

// Looks from `eye` at `target`; `up` need not be orthogonal to the view, and when it is parallel to
// it, an arbitrary but fixed up is used. World frame, metres.
struct Camera {
  Vector3 eye = Vector3(1, -1, 1);
  Vector3 target = Vector3::Zero();
  Vector3 up = Vector3::UnitZ();
  double vertical_field_of_view = 0.6;  // radians, in (0, pi)
};

// A camera together with the size of its picture. Camera frame C: origin at the eye, x to the
// right, y down, z into the scene. Pixel coordinates: origin at the upper left corner of the
// picture, the center of the first pixel at (1/2, 1/2).
class Projection {
 public:
  // Throws InputError when the camera sees nothing: eye at the target, numbers that are not finite,
  // or a field of view out of range.
  Projection(const Camera& camera, int width, int height);

  const Pose& X_CW() const { return X_CW_; }
  // What is nearer than this depth (z in C, metres) is not drawn.
  double near_depth() const { return near_depth_; }

  // Pixel at which a point with positive depth is seen.
  Eigen::Vector2d pixel(const Vector3& p_C) const;
  // Direction in C, with z = 1, of the line of sight through a pixel; inverse of pixel().
  Vector3 line_of_sight(const Eigen::Vector2d& pixel) const;

 private:
  Pose X_CW_;
  Eigen::Vector2d center_;
  double focal_length_;  // pixels
  double near_depth_;
};

// The nearest camera that sees all `points` from `direction` (from the target to the eye, any
// length), with a margin of 5 % on each side, in a picture of `width` x `height`. The z axis points
// up, or the y axis when it looks along z. Throws InputError when there are no points, when one is
// not finite, or when `direction` is zero.
Camera camera_around(const std::vector<Vector3>& points, const Vector3& direction, int width,
                     int height);

// The same for the corners of a box. Throws InputError when it is empty.
Camera camera_around(const Bounds& box, const Vector3& direction, int width, int height);

}  // namespace prehend
