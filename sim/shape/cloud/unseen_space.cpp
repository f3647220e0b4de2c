#include "sim/shape/cloud/unseen_space.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "sim/base/index.h"

namespace prehend {
namespace {

constexpr double kBehind = 0.01;  // [m]: surfaces are wrong by less

// Of the pixel that shows the point, how far the point is behind what it shows [m]; not a number
// where there is no reading.
double behind_reading(const DepthView& view, const Vector3& p_W) {
  const DepthCamera& camera = view.camera;
  const Vector3 p_C = camera.X_WC.inverse() * p_W;
  if (p_C.z() <= 0.0) return std::nan("");
  const double u = std::round(camera.fx * p_C.x() / p_C.z() + camera.cx);
  const double v = std::round(camera.fy * p_C.y() / p_C.z() + camera.cy);
  if (!(u >= 0.0 && v >= 0.0 && u < camera.width && v < camera.height)) return std::nan("");
  const std::size_t pixel =
      static_cast<std::size_t>(v) * index(camera.width) + static_cast<std::size_t>(u);
  const auto depth = static_cast<double>(view.depth[pixel]);
  return std::isfinite(depth) && depth > 0.0 ? p_C.z() - depth : std::nan("");
}

}  // namespace

bool UnseenSpace::contains(const Vector3& p_W) const {
  bool hidden = false;
  for (const DepthView& view : views_) {
    const double behind = behind_reading(view, p_W);
    if (behind <= kBehind) return false;
    hidden = hidden || behind > kBehind;
  }
  return hidden;
}

}  // namespace prehend
