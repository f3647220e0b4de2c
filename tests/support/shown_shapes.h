// Depth images of balls, boxes and upright cylinders on a table, from closed forms.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "sim/base/index.h"
#include "sim/base/random.h"
#include "sim/shape/cloud/depth_view.h"
#include "tests/support/depth_camera.h"

namespace prehend {

// A shape in its own frame S, in the middle of which the origin is.
struct ShownShape {
  enum class Kind { ball, box, cylinder } kind = Kind::ball;
  Vector3 half = Vector3::Constant(0.03);  // radius of ball and cylinder in x, half height in z [m]
  Pose X_WS = Pose::Identity();

  // Negative inside [m]; the distance outside, but for corners, where it is less.
  double distance(const Vector3& p_W) const {
    const Vector3 p = X_WS.inverse() * p_W;
    if (kind == Kind::ball) return p.norm() - half.x();
    if (kind == Kind::cylinder) {
      return std::max(p.head<2>().norm() - half.x(), std::abs(p.z()) - half.z());
    }
    return (p.cwiseAbs() - half).maxCoeff();
  }
  double volume() const {
    const double pi = 3.14159265358979;
    if (kind == Kind::ball) return 4.0 / 3.0 * pi * std::pow(half.x(), 3);
    if (kind == Kind::cylinder) return 2.0 * pi * half.x() * half.x() * half.z();
    return 8.0 * half.prod();
  }
};

// The way along a unit ray to a shape, by steps of its distance (Hart 1996); infinite beyond 3 m.
inline double way_to(const ShownShape& shape, const Vector3& from, const Vector3& along) {
  double way = 0.0;
  for (int step = 0; step < 400 && way < 3.0; ++step) {
    const double distance = shape.distance(from + way * along);
    if (distance < 1e-7) return way;
    way += distance;
  }
  return std::numeric_limits<double>::infinity();
}

// What the camera sees of the shapes and of the plane z = 0 within 0.5 m, with normal noise of
// `deviation` [m]. Without `table`, pixels beside the shapes have no reading.
inline DepthView view_of(const DepthCamera& camera, const std::vector<ShownShape>& shapes,
                         double deviation, bool table = true) {
  DepthView view{camera, {}};
  Random random(11);
  const Vector3 from = camera.X_WC.translation();
  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; ++u) {
      const Vector3 ray_C((u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy, 1.0);
      const Vector3 along = (camera.X_WC.linear() * ray_C).normalized();
      double way = std::numeric_limits<double>::infinity();
      if (table && along.z() < 0.0) {
        const double down = -from.z() / along.z();
        if ((from + down * along).norm() < 0.5) way = down;
      }
      for (const ShownShape& shape : shapes) way = std::min(way, way_to(shape, from, along));
      const double noise = deviation * random.normal();
      const bool seen = std::isfinite(way);
      view.depth.push_back(seen ? static_cast<float>(way / ray_C.norm() + noise) : 0.0F);
    }
  }
  return view;
}

// The camera of most tests: 0.65 m from the middle, 40 degrees down.
inline DepthCamera camera_around(double angle, const Vector3& target = Vector3(0, 0, 0.04)) {
  const Vector3 way(std::cos(angle) * 0.766, std::sin(angle) * 0.766, 0.643);
  return test::camera_at(target + 0.65 * way, target);
}

}  // namespace prehend
