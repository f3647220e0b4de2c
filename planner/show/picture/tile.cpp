#include "planner/show/picture/tile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace prehend {
namespace {

// Rasterisation with several samples a pixel. For each triangle and each pixel of its bounding box:
// find the samples that lie inside (edge functions, Pineda 1988), shade once if any of them is
// visible, and store colour and depth at these samples. Solid surfaces keep the nearest only;
// translucent ones are kept as a sorted list and blended when the tile is finished.

constexpr std::size_t kMostSamples = 64;  // of a pixel

// The edge function a x + b y + c of a side: positive on the inner side of the line through two
// corners, and proportional to the distance from it. Divided by their sum, the three values of a
// triangle are its barycentric coordinates.
//
// Two triangles that share an edge get exactly opposite values, because the line is always computed
// from the same end (`swapped`); samples exactly on the line belong to only one of the two, chosen
// by the sign of the coefficients (`takes_zero`). So no sample on an edge is missed or drawn twice.
struct Side {
  double a, b, c;
  bool takes_zero;

  Side(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
    const bool swapped = std::make_pair(to.x(), to.y()) < std::make_pair(from.x(), from.y());
    const Eigen::Vector2d& p = swapped ? to : from;
    const Eigen::Vector2d& q = swapped ? from : to;
    const double sign = swapped ? -1.0 : 1.0;
    a = sign * (p.y() - q.y());
    b = sign * (q.x() - p.x());
    c = sign * -((p.y() - q.y()) * p.x() + (q.x() - p.x()) * p.y());
    takes_zero = a > 0.0 || (a == 0.0 && b > 0.0);
  }

  double at(double x, double y) const { return a * x + b * y + c; }
  bool takes(double value) const { return value > 0.0 || (value == 0.0 && takes_zero); }
};

struct PixelRange {
  int first = 0;
  int end = 0;
};

// Pixels within `size` of `start` that the interval from `low` to `high` touches.
PixelRange touched(double low, double high, int start, int size) {
  const double first = std::clamp(std::floor(low), double(start), double(start + size));
  const double end = std::clamp(std::floor(high) + 1.0, double(start), double(start + size));
  return {static_cast<int>(first), static_cast<int>(end)};
}

// The samples of one pixel that a triangle covers, with their depths.
struct Covered {
  std::array<std::size_t, kMostSamples> samples;
  std::array<float, kMostSamples> inverse_depths;
  std::size_t count = 0;
  Vector3 weights = Vector3::Zero();  // of the corners, summed over the samples
};

}  // namespace

Tile::Tile(const Projection& projection, const Lights& lights, int samples, const Light& background)
    : projection_(projection), lights_(lights), background_(background) {
  // A sheared grid of samples x samples positions: the positions in row j are shifted to the right
  // by (j + 1/2) / samples of a cell, those in column i up by (i + 1/2) / samples, so that all x
  // and all y are different. A nearly vertical or horizontal edge then crosses the samples one by
  // one, not a whole row at once.
  for (int j = 0; j < samples; ++j) {
    for (int i = 0; i < samples; ++i) {
      offsets_.emplace_back((i + (j + 0.5) / samples) / samples,
                            (j + (samples - 1 - i + 0.5) / samples) / samples);
    }
  }
  const std::size_t count = offsets_.size() * std::size_t{kSize} * std::size_t{kSize};
  surfaces_.resize(count);
  layers_.resize(count * std::size_t{kMostLayers});
  layer_counts_.resize(count);
}

void Tile::move_to(int left, int top) {
  left_ = left;
  top_ = top;
  std::fill(surfaces_.begin(), surfaces_.end(), Surface{0.0F, background_});
  std::fill(layer_counts_.begin(), layer_counts_.end(), std::uint8_t{0});
}

void Tile::add(const ScreenTriangle& triangle) {
  const auto& corners = triangle.corners;
  const Side sides[3] = {
      {corners[1], corners[2]}, {corners[2], corners[0]}, {corners[0], corners[1]}};
  const auto [low_x, high_x] = std::minmax({corners[0].x(), corners[1].x(), corners[2].x()});
  const auto [low_y, high_y] = std::minmax({corners[0].y(), corners[1].y(), corners[2].y()});
  const PixelRange columns = touched(low_x, high_x, left_, kSize);
  const PixelRange rows = touched(low_y, high_y, top_, kSize);
  const Vector3 inverse_depths(triangle.inverse_depths.data());
  for (int y = rows.first; y < rows.end; ++y) {
    for (int x = columns.first; x < columns.end; ++x) {
      const auto pixel = static_cast<std::size_t>((y - top_) * kSize + (x - left_));
      Covered covered;
      bool any_visible = false;
      for (std::size_t s = 0; s < offsets_.size(); ++s) {
        const double at_x = x + offsets_[s].x();
        const double at_y = y + offsets_[s].y();
        const Vector3 inner(sides[0].at(at_x, at_y), sides[1].at(at_x, at_y),
                            sides[2].at(at_x, at_y));
        if (!sides[0].takes(inner[0]) || !sides[1].takes(inner[1]) || !sides[2].takes(inner[2])) {
          continue;
        }
        const double sum = inner.sum();
        if (!(sum > 0.0)) continue;
        const std::size_t sample = pixel * offsets_.size() + s;
        const auto inverse_depth = static_cast<float>(inner.dot(inverse_depths) / sum);
        covered.samples[covered.count] = sample;
        covered.inverse_depths[covered.count] = inverse_depth;
        ++covered.count;
        covered.weights += inner / sum;
        any_visible = any_visible || visible(triangle, sample, inverse_depth);
      }
      if (!any_visible) continue;
      // Shading is the expensive part, so it is done once for all covered samples of the pixel, at
      // their mean position. That lies inside the triangle, and depends on no other triangle.
      const Look look = look_at(triangle, covered.weights / static_cast<double>(covered.count));
      for (std::size_t i = 0; i < covered.count; ++i) {
        put(triangle, look, covered.samples[i], covered.inverse_depths[i]);
      }
    }
  }
}

// Colour and opacity of a triangle at the given barycentric coordinates (on the screen).
Tile::Look Tile::look_at(const ScreenTriangle& triangle, const Vector3& weights) const {
  if (!triangle.lit) return {triangle.albedo, triangle.opacity};
  constexpr double kGrazing = 0.3;  // cosine below which a shell grows no denser
  Vector3 normal = Vector3::Zero();
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
  for (std::size_t k = 0; k < 3; ++k) {
    const double weight = weights[static_cast<Eigen::Index>(k)];
    // Perspective-correct interpolation: a quantity that is linear on the surface is linear on the
    // screen only after division by depth. The common factor drops out when the normal is
    // normalised.
    normal += weight * triangle.inverse_depths[k] * triangle.normals[k];
    pixel += weight * triangle.corners[k];
  }
  const Vector3 to_eye = -projection_.line_of_sight(pixel).normalized();
  const double norm = normal.norm();
  normal = norm > 0.0 ? Vector3(normal / norm) : to_eye;
  double cosine = normal.dot(to_eye);
  if (cosine < 0.0) {
    // An interpolated normal may point away from the viewer near the outline, where light would
    // come from behind the surface: its component along the line of sight is removed.
    normal -= cosine * to_eye;
    normal = normal.norm() > 0.0 ? Vector3(normal.normalized()) : to_eye;
    cosine = 0.0;
  }
  Look look{lights_.reflected(triangle.albedo, normal, to_eye), triangle.opacity};
  if (!triangle.solid()) {
    // Light crosses a thin shell on a path that is longer by 1 / cosine than straight through, and
    // transmission falls exponentially with the path (Beer-Lambert law).
    const double clear = 1.0 - static_cast<double>(triangle.opacity);
    look.opacity = static_cast<float>(1.0 - std::pow(clear, 1.0 / std::max(cosine, kGrazing)));
  }
  return look;
}

// Whether a lies before b: the nearer one; at equal depth it is decided by colour, so that the
// result does not depend on the order in which triangles are drawn.
bool Tile::before(const Surface& a, const Surface& b) {
  if (a.inverse_depth != b.inverse_depth) return a.inverse_depth > b.inverse_depth;
  return a.light < b.light;
}

// Whether a surface at this depth would be seen in a sample, given the solid surfaces so far.
bool Tile::visible(const ScreenTriangle& triangle, std::size_t sample, float inverse_depth) const {
  // A translucent surface in the same plane as a solid one counts as in front of it. Otherwise
  // rounding would decide for each sample, which shows as a speckled pattern.
  constexpr float kSamePlane = 1.0F + 2e-4F;
  const float solid = surfaces_[sample].inverse_depth;
  return triangle.solid() ? inverse_depth >= solid : inverse_depth * kSamePlane >= solid;
}

void Tile::put(const ScreenTriangle& triangle, const Look& look, std::size_t sample,
               float inverse_depth) {
  const Surface surface{inverse_depth, look.light};
  if (triangle.solid()) {
    if (before(surface, surfaces_[sample])) surfaces_[sample] = surface;
  } else if (visible(triangle, sample, inverse_depth)) {
    insert({surface, look.opacity}, sample);
  }
}

// Inserts a layer into the sample's list, nearest first. When the list is full, the farthest layer
// is dropped: it is hidden behind 24 others and adds least to the colour.
void Tile::insert(const Layer& layer, std::size_t sample) {
  const auto nearer = [](const Layer& a, const Layer& b) {
    if (before(a.surface, b.surface)) return true;
    return !before(b.surface, a.surface) && a.opacity < b.opacity;
  };
  Layer* const first = &layers_[sample * std::size_t{kMostLayers}];
  int place = layer_counts_[sample];
  if (place == kMostLayers) {
    --place;
    if (!nearer(layer, first[place])) return;
  } else {
    ++layer_counts_[sample];
  }
  for (; place > 0 && nearer(layer, first[place - 1]); --place) first[place] = first[place - 1];
  first[place] = layer;
}

// Colour of a sample: starting from the solid surface or the background, each translucent layer,
// farthest first, is blended over what is behind it.
Light Tile::seen(std::size_t sample) const {
  Light light = surfaces_[sample].light;
  const Layer* const first = &layers_[sample * std::size_t{kMostLayers}];
  for (int i = layer_counts_[sample] - 1; i >= 0; --i) {
    for (std::size_t k = 0; k < 3; ++k) {
      light[k] += first[i].opacity * (first[i].surface.light[k] - light[k]);
    }
  }
  return light;
}

void Tile::write_to(Image& image) const {
  const int right = std::min(left_ + kSize, image.width);
  const int bottom = std::min(top_ + kSize, image.height);
  for (int y = top_; y < bottom; ++y) {
    for (int x = left_; x < right; ++x) {
      const auto pixel = static_cast<std::size_t>((y - top_) * kSize + (x - left_));
      Light sum{};
      for (std::size_t s = 0; s < offsets_.size(); ++s) {
        const Light light = seen(pixel * offsets_.size() + s);
        // Clamped before averaging: a highlight far brighter than white would otherwise dominate
        // the mean of pixels at its border and make the border jagged.
        for (std::size_t k = 0; k < 3; ++k) sum[k] += std::min(light[k], 1.0F);
      }
      const auto at = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                           static_cast<std::size_t>(x));
      for (std::size_t k = 0; k < 3; ++k) {
        image.rgb[at + k] = display_byte(sum[k] / static_cast<float>(offsets_.size()));
      }
    }
  }
}

}  // namespace prehend
