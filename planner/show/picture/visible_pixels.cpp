#include "planner/show/picture/visible_pixels.h"

#include <algorithm>
#include <cmath>

#include "planner/show/picture/screen_triangle.h"

namespace prehend {
namespace {

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// A renderer reduced to what counting needs: one sample at the centre of each pixel, no shading and
// no antialiasing. It runs for many directions for each picture (best_viewpoint).

// For each pixel, which solid body is the nearest there, and how much of it can be seen.
class Pixels {
 public:
  Pixels(int width, int height)
      : width_(width),
        height_(height),
        bodies_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), -1),
        inverse_depths_(bodies_.size(), 0.0),
        uncovered_(bodies_.size(), 1.0) {}

  // All solid triangles must be added before the first translucent one, which counts only where no
  // solid one is nearer.
  void add(const ScreenTriangle& triangle, int body) {
    const auto& p = triangle.corners;
    const Eigen::Vector2d low = p[0].cwiseMin(p[1]).cwiseMin(p[2]);
    const Eigen::Vector2d high = p[0].cwiseMax(p[1]).cwiseMax(p[2]);
    // Barycentric coordinates of the pixel centre are signed areas over the whole area, which is
    // positive and not 0 (ScreenTriangle). A centre exactly on a common edge belongs to both
    // triangles. For solid ones that changes nothing; two translucent ones both dim it.
    const double area = cross(p[1] - p[0], p[2] - p[0]);
    const int end_x = pixel_end(high.x(), width_);
    const int end_y = pixel_end(high.y(), height_);
    for (int y = pixel_first(low.y(), height_); y < end_y; ++y) {
      for (int x = pixel_first(low.x(), width_); x < end_x; ++x) {
        const Eigen::Vector2d center(x + 0.5, y + 0.5);
        const double a = cross(p[2] - p[1], center - p[1]) / area;
        const double b = cross(p[0] - p[2], center - p[2]) / area;
        const double c = cross(p[1] - p[0], center - p[0]) / area;
        if (!(a >= 0.0 && b >= 0.0 && c >= 0.0)) continue;
        const auto& depths = triangle.inverse_depths;
        const double inverse_depth = a * depths[0] + b * depths[1] + c * depths[2];
        const auto at = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                        static_cast<std::size_t>(x);
        // Strictly nearer: of two bodies at the same depth the first one counts. A translucent
        // surface dims a pixel only where it is before the solid one; several multiply.
        if (!(inverse_depth > inverse_depths_[at])) continue;
        if (triangle.solid()) {
          inverse_depths_[at] = inverse_depth;
          bodies_[at] = body;
        } else {
          uncovered_[at] *= 1.0 - double{triangle.opacity};
        }
      }
    }
  }

  std::vector<double> seen(std::size_t bodies) const {
    std::vector<double> sums(bodies, 0.0);
    for (std::size_t at = 0; at < bodies_.size(); ++at) {
      if (bodies_[at] >= 0) sums[static_cast<std::size_t>(bodies_[at])] += uncovered_[at];
    }
    return sums;
  }

 private:
  // Clamped while it is a double: a corner may project to a pixel that is outside the range of int.
  static int pixel_first(double at, int count) {
    return static_cast<int>(std::clamp(std::floor(at), 0.0, double(count)));
  }
  static int pixel_end(double at, int count) {
    return static_cast<int>(std::clamp(std::floor(at) + 1.0, 0.0, double(count)));
  }

  int width_;
  int height_;
  std::vector<int> bodies_;  // -1: none
  std::vector<double> inverse_depths_;
  std::vector<double> uncovered_;
};

void add_body(const DrawnBody& body, int number, const Projection& projection, Pixels& pixels) {
  const auto opacity = static_cast<float>(body.color.opacity);
  // As in draw.cpp: the back of a translucent surface covers half as much as its front.
  const SurfaceLook look{{}, opacity, opacity >= 1.0F ? opacity : 0.5F * opacity};
  const Pose X_CB = projection.X_CW() * body.X_WB;
  std::vector<CameraVertex> vertices(body.mesh->vertices.size());
  for (std::size_t v = 0; v < vertices.size(); ++v) vertices[v].p_C = X_CB * body.mesh->vertices[v];
  std::vector<ScreenTriangle> triangles;
  for (const Triangle& t : body.mesh->triangles) {
    append_triangle(
        {vertices[static_cast<std::size_t>(t[0])], vertices[static_cast<std::size_t>(t[1])],
         vertices[static_cast<std::size_t>(t[2])]},
        look, projection, triangles);
  }
  for (const ScreenTriangle& triangle : triangles) pixels.add(triangle, number);
}

}  // namespace

std::vector<double> visible_pixels(const std::vector<DrawnBody>& seen,
                                   const std::vector<DrawnBody>& around, const Camera& camera,
                                   int width, int height) {
  const Projection projection(camera, width, height);
  Pixels pixels(width, height);
  // Bodies have the same number in both passes: first those that are counted, then those around
  // them, which are cut off at the end.
  for (const bool solid : {true, false}) {
    int number = 0;
    for (const std::vector<DrawnBody>* bodies : {&seen, &around}) {
      for (const DrawnBody& body : *bodies) {
        if ((body.color.opacity >= 1.0) == solid) add_body(body, number, projection, pixels);
        ++number;
      }
    }
  }
  std::vector<double> counts = pixels.seen(seen.size() + around.size());
  counts.resize(seen.size());
  return counts;
}

}  // namespace prehend
