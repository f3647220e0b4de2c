#include "sim/shape/moments_inside.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace prehend {
namespace {

// The corners of a convex polygon; none: it is empty.
using ConePatch = std::vector<Vector3>;

// The ratios of a triangle's corners to each plane.
using CornerRatios = std::array<double, 3>;

// Cuts tetrahedra with the apex at the origin by planes slope . x <= 1.
class ConeCutter {
 public:
  explicit ConeCutter(std::vector<Vector3> slopes) : slopes_(std::move(slopes)) {}

  const Moments& sum() const { return sum_; }

  void add(const std::array<Vector3, 3>& corners) {
    measure(corners);
    if (crossed_.empty()) {
      add_tetrahedron(sum_, corners[0], corners[1], corners[2]);
      return;
    }
    start(corners);
    for (const std::size_t j : crossed_) keep(-slopes_[j], 1.0);
    add_cone();
    for (const std::size_t j : crossed_) add_beyond(corners, j);
  }

 private:
  // The planes that a part of the triangle is beyond, without those that others are met before
  // everywhere on it.
  void measure(const std::array<Vector3, 3>& corners) {
    crossed_.clear();
    ratios_.clear();
    std::array<std::size_t, 3> first{};
    for (std::size_t j = 0; j < slopes_.size(); ++j) {
      CornerRatios& ratio = ratios_.emplace_back();
      for (std::size_t k = 0; k < 3; ++k) {
        ratio[k] = slopes_[j].dot(corners[k]);
        if (ratio[k] > ratios_[first[k]][k]) first[k] = j;
      }
    }
    for (std::size_t j = 0; j < slopes_.size(); ++j) {
      if (*std::max_element(ratios_[j].begin(), ratios_[j].end()) <= 1.0) continue;
      const auto hides = [&](std::size_t other) { return is_before(other, j); };
      if (std::none_of(first.begin(), first.end(), hides)) crossed_.push_back(j);
    }
  }

  // Whether plane `other` is met before plane j on the whole triangle; of equal ones the first.
  bool is_before(std::size_t other, std::size_t j) const {
    if (other == j) return false;
    bool equal = true;
    for (std::size_t k = 0; k < 3; ++k) {
      if (ratios_[other][k] < ratios_[j][k]) return false;
      equal = equal && ratios_[other][k] == ratios_[j][k];
    }
    return !equal || other < j;
  }

  // The part of the tetrahedron between the origin and plane j, where that is met first.
  void add_beyond(const std::array<Vector3, 3>& corners, std::size_t j) {
    start(corners);
    keep(slopes_[j], -1.0);
    for (const std::size_t other : crossed_) {
      if (other != j) keep(slopes_[j] - slopes_[other], 0.0);
    }
    for (Vector3& x : patch_) x /= slopes_[j].dot(x);
    add_cone();
  }

  void start(const std::array<Vector3, 3>& corners) {
    patch_.assign(corners.begin(), corners.end());
  }

  // Keeps the part of the polygon where slope . x + constant >= 0.
  void keep(const Vector3& slope, double constant) {
    kept_.clear();
    for (std::size_t i = 0; i < patch_.size(); ++i) {
      const Vector3& a = patch_[i];
      const Vector3& b = patch_[(i + 1) % patch_.size()];
      const double at_a = slope.dot(a) + constant;
      const double at_b = slope.dot(b) + constant;
      if (at_a >= 0.0) kept_.push_back(a);
      if ((at_a >= 0.0) != (at_b >= 0.0)) kept_.push_back(a + at_a / (at_a - at_b) * (b - a));
    }
    std::swap(patch_, kept_);
  }

  void add_cone() {
    for (std::size_t i = 2; i < patch_.size(); ++i) {
      add_tetrahedron(sum_, patch_[0], patch_[i - 1], patch_[i]);
    }
  }

  std::vector<Vector3> slopes_;
  Moments sum_;
  std::vector<CornerRatios> ratios_;
  std::vector<std::size_t> crossed_;
  ConePatch patch_;
  ConePatch kept_;
};

// The gradients of the ratios, for an apex inside all planes. Of planes that are the same but for
// rounding only the first is kept: what lies behind them would count for each.
std::vector<Vector3> slopes_from(const ConvexRegion& region, const Vector3& apex) {
  constexpr double kSame = 1e-12;
  std::vector<Vector3> slopes;
  for (const HalfSpace& half : region) {
    const Vector3 slope = half.normal / (half.offset - half.normal.dot(apex));
    const auto same = [&](const Vector3& other) {
      return (other - slope).norm() <= kSame * slope.norm();
    };
    if (std::none_of(slopes.begin(), slopes.end(), same)) slopes.push_back(slope);
  }
  return slopes;
}

}  // namespace

Moments moments_inside(const TriangleMesh& surface, const ConvexRegion& region) {
  const std::optional<Vector3> apex = inner_point(region, bounds(surface));
  if (!apex) return {};
  ConeCutter cutter(slopes_from(region, *apex));
  for (const Triangle& t : surface.triangles) {
    std::array<Vector3, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = surface.vertices[static_cast<std::size_t>(t[k])] - *apex;
    }
    cutter.add(corners);
  }
  return shifted(cutter.sum(), *apex);
}

}  // namespace prehend
