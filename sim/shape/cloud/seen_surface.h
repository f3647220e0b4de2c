// What single readings of a depth camera say of the surface, once their noise is averaged out.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "sim/base/index.h"
#include "sim/shape/cloud/depth_view.h"

namespace prehend {

// The plane through a piece of surface, in the frame C of the camera: the points p with
// inverse . p = 1. It points along the normal away from the camera and has 1 / distance as length
// [1/m].
struct LocalPlane {
  Eigen::Vector3f inverse = Eigen::Vector3f::Zero();

  bool exists() const { return inverse.z() > 0.0F; }
  // Of a point of C: positive on the side of the camera [m].
  float distance(const Eigen::Vector3f& p_C) const {
    return (1.0F - inverse.dot(p_C)) / inverse.norm();
  }
  // Unit, towards the camera.
  Eigen::Vector3f normal() const { return -inverse.normalized(); }
};

// The unit-depth ray through a pixel, frame C.
inline Eigen::Vector3f pixel_ray(const DepthCamera& camera, int u, int v) {
  return {static_cast<float>((u - camera.cx) / camera.fx),
          static_cast<float>((v - camera.cy) / camera.fy), 1.0F};
}

// Where the reading of a pixel is, frame C [m].
inline Eigen::Vector3f reading_at(const DepthView& view, int u, int v) {
  const float depth = view.depth[index(v) * index(view.camera.width) + index(u)];
  return depth * pixel_ray(view.camera, u, v);
}

// The standard deviation of the readings [m]: the median of second differences along rows, which
// planes do not have. At least 0.1 mm.
double noise_of(const DepthView& view);

// Fits planes to windows of pixels: least squares of the inverse depth, which is linear in the
// pixel on a plane, first of the readings near the one in the middle, then of those within three
// deviations of the first plane. So edges of depth are kept.
class PlaneFitter {
 public:
  // `noise` as of noise_of.
  PlaneFitter(const DepthView& view, double noise);

  // None where there is no reading, or too few others are near it.
  LocalPlane at(int u, int v) const;
  int radius() const { return radius_; }  // of the window [pixels]

 private:
  const DepthView* view_;
  double noise_;
  int radius_;
};

}  // namespace prehend
