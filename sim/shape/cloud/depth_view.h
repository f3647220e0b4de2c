// What a depth camera saw from one place.
#pragma once

#include <vector>

#include "sim/base/pose.h"

namespace prehend {

// A pinhole camera without distortion, at a pose in the world. Frame C: x to the right of the
// image, y down, z into the scene. Pixel (u, v) is the middle of column u and row v, from 0; a
// point p_C is seen at u = fx x / z + cx, v = fy y / z + cy.
struct DepthCamera {
  double fx = 0.0;  // focal lengths [pixels], positive
  double fy = 0.0;
  double cx = 0.0;  // where the axis meets the image [pixels]
  double cy = 0.0;
  int width = 0;  // [pixels]
  int height = 0;
  Pose X_WC = Pose::Identity();
};

struct DepthView {
  DepthCamera camera;
  // Along z of the camera [m], row by row from the top: height x width; 0 where there is no
  // reading.
  std::vector<float> depth;
};

}  // namespace prehend
