// Cameras that look at something, upright.
#pragma once

#include "sim/shape/cloud/depth_view.h"

namespace prehend::test {

// The size of an image, and its focal length [pixels]; the axis meets its middle.
struct ImageSize {
  int width = 640;
  int height = 480;
  double focal = 570.0;
};

// At `position`, looking at `target`, which is not straight above or below; z of the world is up in
// its image.
inline DepthCamera camera_at(const Vector3& position, const Vector3& target,
                             const ImageSize& size = {}) {
  DepthCamera camera{size.focal, size.focal, 0.5 * (size.width - 1), 0.5 * (size.height - 1),
                     size.width, size.height};
  const Vector3 z = (target - position).normalized();
  const Vector3 x = z.cross(Vector3::UnitZ()).normalized();
  Matrix3 axes;
  axes << x, z.cross(x), z;
  camera.X_WC = pose_from(axes, position);
  return camera;
}

}  // namespace prehend::test
