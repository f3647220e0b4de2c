#include "planner/show/picture/tile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace prehend {
namespace {

// Rasterisation with several samples a pixel. For each triangle and each pixel of its bounding box
// that may show it: find the samples that lie inside (edge functions, Pineda 1988), shade once if
// any of them is visible, and store colour and depth at these samples. Solid surfaces keep the
// nearest only; translucent ones are kept as a sorted list and blended when the tile is finished.

constexpr std::size_t kMostSamples = 64;  // of a pixel

// A translucent surface in the same plane as a solid one counts as in front of it. Otherwise
// rounding would decide for each sample, which shows as a speckled pattern.
constexpr float kSamePlane = 1.0F + 2e-4F;

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

// Pixels of `range` that the interval from `low` to `high` touches. Neither may be below 0, so that
// casts round down.
PixelRange touched(double low, double high, const PixelRange& range) {
  if (!(low < range.end) || high < range.first) return {};
  return {static_cast<int>(std::max(low, double(range.first))),
          static_cast<int>(std::min(high, range.end - 1.0)) + 1};
}

// A triangle within one tile.
class FlatTriangle {
 public:
  FlatTriangle(const ScreenTriangle& triangle, int right, int bottom)
      : sides_{Side(triangle.corners[1], triangle.corners[2]),
               Side(triangle.corners[2], triangle.corners[0]),
               Side(triangle.corners[0], triangle.corners[1])},
        first_(triangle.corners[0]),
        at_first_(triangle.inverse_depths[0]),
        least_(std::min({at_first_, triangle.inverse_depths[1], triangle.inverse_depths[2]})),
        most_(std::max({at_first_, triangle.inverse_depths[1], triangle.inverse_depths[2]})) {
    // 1 / depth is linear across the picture.
    const double area = sides_[0].at(first_.x(), first_.y());
    for (std::size_t k = 0; k < 3; ++k) {
      const Side& side = sides_[k];
      along_ += triangle.inverse_depths[k] / area * Eigen::Vector2d(side.a, side.b);
      slacks_[k] =
          1e-12 * (std::abs(side.a) * right + std::abs(side.b) * bottom + std::abs(side.c));
    }
    if (!along_.allFinite()) along_.setZero();
  }

  // Of the pixels of a row, those that the triangle may touch. Of the box around a long and thin
  // one, such as a line's, most pixels are far from it.
  PixelRange touched_in_row(int y, const PixelRange& columns) const {
    double low = columns.first;
    double high = columns.end;
    for (std::size_t k = 0; k < 3; ++k) {
      const Side& side = sides_[k];
      // In this row the side's value at x is at most a x + top.
      const double top = side.at(0.0, y) + std::max(side.b, 0.0) + slacks_[k];
      if (side.a > 0.0) low = std::max(low, -top / side.a);
      if (side.a < 0.0) high = std::min(high, -top / side.a);
      if (side.a == 0.0 && top < 0.0) return {};
    }
    return touched(low, high, columns);
  }

  // Whether all samples of the pixel whose upper left corner is at (x, y) lie inside, decided by
  // the smallest value of each side in it.
  bool contains_pixel(int x, int y) const {
    for (std::size_t k = 0; k < 3; ++k) {
      const Side& side = sides_[k];
      const double least = side.at(x, y) + std::min(side.a, 0.0) + std::min(side.b, 0.0);
      if (!(least > slacks_[k])) return false;
    }
    return true;
  }

  bool covers(const Eigen::Vector2d& p) const {
    return std::all_of(sides_.begin(), sides_.end(),
                       [&](const Side& side) { return side.takes(side.at(p.x(), p.y())); });
  }

  // Limited to that of the corners where a triangle is so thin that rounding spoils the slopes.
  float inverse_depth(const Eigen::Vector2d& p) const {
    const double value = at_first_ + along_.dot(p - first_);
    return static_cast<float>(std::clamp(value, least_, most_));
  }

  double nearest() const { return most_; }  // 1 / depth

  // Barycentric coordinates.
  Vector3 weights(const Eigen::Vector2d& p) const {
    Vector3 inner;
    for (std::size_t k = 0; k < 3; ++k) {
      inner[static_cast<Eigen::Index>(k)] = std::max(sides_[k].at(p.x(), p.y()), 0.0);
    }
    const double sum = inner.sum();
    return sum > 0.0 ? Vector3(inner / sum) : Vector3::Constant(1.0 / 3.0);
  }

 private:
  std::array<Side, 3> sides_;
  std::array<double, 3> slacks_{};
  Eigen::Vector2d first_;  // corner
  double at_first_;        // 1 / depth there
  double least_;           // 1 / depth of the farthest and the nearest corner
  double most_;
  Eigen::Vector2d along_ = Eigen::Vector2d::Zero();  // change of 1 / depth a pixel
};

// The samples of one pixel that a triangle covers, with their depths.
struct Covered {
  std::array<std::size_t, kMostSamples> samples;
  std::array<float, kMostSamples> inverse_depths;
  std::size_t count = 0;
  Eigen::Vector2d center = Eigen::Vector2d::Zero();  // summed over the samples
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
  farthest_.resize(std::size_t{kSize} * std::size_t{kSize});
}

void Tile::move_to(int left, int top) {
  left_ = left;
  top_ = top;
  std::fill(surfaces_.begin(), surfaces_.end(), Surface{0.0F, background_});
  std::fill(layer_counts_.begin(), layer_counts_.end(), std::uint8_t{0});
  std::fill(farthest_.begin(), farthest_.end(), 0.0F);
}

void Tile::add(const ScreenTriangle& triangle) {
  const auto& corners = triangle.corners;
  const auto [low_x, high_x] = std::minmax({corners[0].x(), corners[1].x(), corners[2].x()});
  const auto [low_y, high_y] = std::minmax({corners[0].y(), corners[1].y(), corners[2].y()});
  const PixelRange columns = touched(low_x, high_x, {left_, left_ + kSize});
  const PixelRange rows = touched(low_y, high_y, {top_, top_ + kSize});
  const FlatTriangle flat(triangle, left_ + kSize, top_ + kSize);
  // No sample counts as nearer (visible); the last factor is above the rounding.
  const auto nearest = static_cast<float>(flat.nearest() * double{kSamePlane} * (1.0 + 1e-6));
  for (int y = rows.first; y < rows.end; ++y) {
    const PixelRange row = flat.touched_in_row(y, columns);
    for (int x = row.first; x < row.end; ++x) {
      const auto pixel = static_cast<std::size_t>((y - top_) * kSize + (x - left_));
      if (nearest < farthest_[pixel]) continue;
      const bool all = flat.contains_pixel(x, y);
      Covered covered;
      bool any_visible = false;
      for (std::size_t s = 0; s < offsets_.size(); ++s) {
        const Eigen::Vector2d p = Eigen::Vector2d(x, y) + offsets_[s];
        if (!all && !flat.covers(p)) continue;
        const std::size_t sample = pixel * offsets_.size() + s;
        const float inverse_depth = flat.inverse_depth(p);
        covered.samples[covered.count] = sample;
        covered.inverse_depths[covered.count] = inverse_depth;
        ++covered.count;
        covered.center += p;
        any_visible = any_visible || visible(triangle, sample, inverse_depth);
      }
      if (!any_visible) continue;
      // Shading is the expensive part, so it is done once for all covered samples of the pixel, at
      // their mean position. That lies inside the triangle, and depends on no other triangle.
      const Look look =
          look_at(triangle, flat.weights(covered.center / static_cast<double>(covered.count)));
      for (std::size_t i = 0; i < covered.count; ++i) {
        put(triangle, look, covered.samples[i], covered.inverse_depths[i]);
      }
      if (triangle.solid()) note_farthest(pixel);
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
  const Vector3 sight = projection_.line_of_sight(pixel);
  const Vector3 to_eye = sight * (-1.0 / sight.norm());
  const double norm = normal.norm();
  normal = norm > 0.0 ? Vector3(normal * (1.0 / norm)) : to_eye;
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
  const float solid = surfaces_[sample].inverse_depth;
  return triangle.solid() ? inverse_depth >= solid : inverse_depth * kSamePlane >= solid;
}

void Tile::note_farthest(std::size_t pixel) {
  const Surface* const first = &surfaces_[pixel * offsets_.size()];
  float farthest = first->inverse_depth;
  for (std::size_t s = 1; s < offsets_.size(); ++s) {
    farthest = std::min(farthest, first[s].inverse_depth);
  }
  farthest_[pixel] = farthest;
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
