#include "planner/show/picture/visible_pixels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "planner/show/picture/screen_triangle.h"
#include "sim/base/index.h"

namespace prehend {
namespace {

double cross(const Vector3& a, const Vector3& b) { return a.x() * b.y() - a.y() * b.x(); }

// The first of `count` pixels whose center is not before `at`. Clamped before the cast: a corner
// may project to a pixel that is outside the range of int.
int first_center(double at, int count) {
  const double place = std::clamp(at - 0.5, 0.0, double(count));
  const int below = static_cast<int>(place);
  return below < place ? below + 1 : below;
}

// As in draw.cpp.
SurfaceLook look_of(const DrawnBody& body) {
  const auto opacity = static_cast<float>(body.color.opacity);
  return {{}, opacity, opacity >= 1.0F ? opacity : 0.5F * opacity};
}

}  // namespace

VisiblePixels::VisiblePixels(const Camera& camera, int width, int height)
    : projection_(camera, width, height),
      width_(width),
      height_(height),
      pixels_(index(width) * index(height)) {}

double VisiblePixels::add(const DrawnBody& body) {
  ++body_;
  covered_ = 0;
  const SurfaceLook look = look_of(body);
  const Pose X_CB = projection_.X_CW() * body.X_WB;
  corners_.clear();
  for (const Vector3& p_B : body.mesh->vertices) {
    const Vector3 p_C = X_CB * p_B;
    Corner& corner = corners_.emplace_back(Corner::Zero());
    if (p_C.z() < projection_.near_depth()) continue;
    corner << projection_.pixel(p_C), 1.0 / p_C.z();
  }
  for (const Triangle& t : body.mesh->triangles) {
    const Corner& a = corners_[index(t[0])];
    const Corner& b = corners_[index(t[1])];
    const Corner& c = corners_[index(t[2])];
    if (a.z() > 0.0 && b.z() > 0.0 && c.z() > 0.0) {
      // Counter-clockwise to the eye is the other sense here, as y points down.
      fill(a, b, c, cross(b - a, c - a) < 0.0 ? look.front_opacity : look.back_opacity);
    } else {
      add_clipped(body, t, X_CB);
    }
  }
  return covered_;
}

// A triangle with a corner before the near plane.
void VisiblePixels::add_clipped(const DrawnBody& body, const Triangle& triangle, const Pose& X_CB) {
  std::array<CameraVertex, 3> vertices;
  for (std::size_t k = 0; k < 3; ++k) {
    vertices[k].p_C = X_CB * body.mesh->vertices[index(triangle[k])];
  }
  std::vector<ScreenTriangle> parts;
  append_triangle(vertices, look_of(body), projection_, parts);
  for (const ScreenTriangle& part : parts) {
    std::array<Corner, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] << part.corners[k], part.inverse_depths[k];
    fill(corners[0], corners[1], corners[2], part.opacity);
  }
}

// Row by row: the pixels whose centers are from one side of the triangle to before the other. A
// side is followed from its upper end whichever triangle it belongs to, so that a center on the
// border of two triangles belongs to one of them.
void VisiblePixels::fill(const Corner& a, const Corner& b, const Corner& c, float opacity) {
  const auto [low_x, high_x] = std::minmax({a.x(), b.x(), c.x()});
  if (first_center(low_x, width_) >= first_center(high_x, width_)) return;
  std::array<const Corner*, 3> corners = {&a, &b, &c};
  if (b.y() < a.y()) std::swap(corners[0], corners[1]);
  if (corners[2]->y() < corners[1]->y()) std::swap(corners[1], corners[2]);
  if (corners[1]->y() < corners[0]->y()) std::swap(corners[0], corners[1]);
  const Corner& top = *corners[0];
  const Corner& middle = *corners[1];
  const Corner& bottom = *corners[2];
  const int first_y = first_center(top.y(), height_);
  const int end_y = first_center(bottom.y(), height_);
  if (first_y >= end_y) return;
  const Vector3 long_side = bottom - top;
  const Vector3 upper_side = middle - top;
  const Vector3 lower_side = bottom - middle;
  const double area = cross(upper_side, long_side);
  if (area == 0.0 || !std::isfinite(area)) return;
  // 1 / depth is linear across the picture.
  const double along_x = (upper_side.z() * long_side.y() - long_side.z() * upper_side.y()) / area;
  const double along_y = (long_side.z() * upper_side.x() - upper_side.z() * long_side.x()) / area;
  const auto [least, most] = std::minmax({top.z(), middle.z(), bottom.z()});
  // Change of x a row. A side along a row has none, and no row's center before its end.
  const double long_slope = long_side.x() / long_side.y();
  const double upper_slope = upper_side.x() / upper_side.y();
  const double lower_slope = lower_side.x() / lower_side.y();
  for (int y = first_y; y < end_y; ++y) {
    const double down = y + 0.5 - top.y();
    const double below = y + 0.5 - middle.y();
    const double one = top.x() + down * long_slope;
    const double other =
        below < 0.0 ? top.x() + down * upper_slope : middle.x() + below * lower_slope;
    const int first_x = first_center(std::min(one, other), width_);
    const int end_x = first_center(std::max(one, other), width_);
    double inverse_depth = top.z() + along_x * (first_x + 0.5 - top.x()) + along_y * down;
    Pixel* const row = &pixels_[index(y) * index(width_)];
    for (Pixel* pixel = row + first_x; pixel < row + end_x; ++pixel, inverse_depth += along_x) {
      // Limited where a triangle is so thin that rounding spoils the slopes.
      touch(static_cast<float>(std::clamp(inverse_depth, least, most)), opacity, *pixel);
    }
  }
}

void VisiblePixels::touch(float inverse_depth, float opacity, Pixel& pixel) {
  covered_ += pixel.last != body_ ? 1 : 0;
  pixel.last = body_;
  // Strictly nearer: of two bodies at the same depth the first one counts.
  if (!(inverse_depth > pixel.inverse_depth)) return;
  if (opacity < 1.0F) {
    pixel.uncovered *= 1.0F - opacity;
    return;
  }
  pixel.inverse_depth = inverse_depth;
  pixel.nearest = body_;
  pixel.uncovered = 1.0F;
}

std::vector<double> VisiblePixels::counts() const {
  std::vector<double> sums(index(body_ + 1), 0.0);
  for (const Pixel& pixel : pixels_) {
    if (pixel.nearest >= 0) sums[index(pixel.nearest)] += double{pixel.uncovered};
  }
  return sums;
}

}  // namespace prehend
