#include "sim/shape/wide_tree.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

#include "sim/base/index.h"
#include "sim/base/wide_lanes.h"

namespace prehend {
namespace {

constexpr float kHalfUnit = 0.5F * std::numeric_limits<float>::epsilon();
// Boxes of lanes without a child. Squares of this are finite.
constexpr float kFar = 1e18F;

// The box in single precision, relative to the origin and rounded outward.
WideBox rounded(const BoxNode& box, const Vector3& origin) {
  WideBox wide;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<Vector3::Index>(k);
    const double center = box.center[axis] - origin[axis];
    wide.center[k] = static_cast<float>(center);
    const double half = box.half[axis] + std::abs(center - static_cast<double>(wide.center[k]));
    wide.half[k] = std::nextafter(static_cast<float>(half), std::numeric_limits<float>::infinity());
  }
  return wide;
}

class WideBuilder {
 public:
  explicit WideBuilder(const std::vector<BoxNode>& binary) : binary_(binary) {
    tree_.origin = binary.front().center;
    tree_.radius = binary.front().half.norm();
  }

  WideTree build() {
    tree_.nodes.reserve(binary_.size() / kLanes + 1);
    tree_.root = rounded(binary_.front(), tree_.origin);
    tree_.nodes.emplace_back();
    fill(0, 0);
    return std::move(tree_);
  }

 private:
  // Up to kLanes nodes of the binary tree whose boxes together hold all below `top`: the one with
  // the largest box is replaced by its children, again and again.
  std::vector<int> children_of(int top) const {
    std::vector<int> open{top};
    while (open.size() < kLanes) {
      const auto largest = std::max_element(open.begin(), open.end(), [&](int i, int j) {
        return size_if_split(i) < size_if_split(j);
      });
      const BoxNode& node = binary_[index(*largest)];
      if (node.is_leaf()) break;
      *largest = node.left;
      open.push_back(node.left + 1);
    }
    return open;
  }

  double size_if_split(int i) const {
    const BoxNode& node = binary_[index(i)];
    return node.is_leaf() ? -1.0 : node.half.squaredNorm();
  }

  void fill(std::size_t wide, int top) {
    const std::vector<int> children = children_of(top);
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      WideBox box{{kFar, kFar, kFar}, {-1.0F, -1.0F, -1.0F}, 0};
      if (lane < children.size()) {
        const BoxNode& node = binary_[index(children[lane])];
        box = rounded(node, tree_.origin);
        box.child = node.is_leaf() ? ~node.triangle : static_cast<int>(tree_.nodes.size());
        if (!node.is_leaf()) tree_.nodes.emplace_back();
      }
      for (std::size_t k = 0; k < 3; ++k) {
        tree_.nodes[wide].center[k][lane] = box.center[k];
        tree_.nodes[wide].half[k][lane] = box.half[k];
      }
      tree_.nodes[wide].child[lane] = box.child;
    }
    for (std::size_t lane = 0; lane < children.size(); ++lane) {
      const WideChild child = tree_.nodes[wide].child[lane];
      if (!is_triangle(child)) fill(index(child), children[lane]);
    }
  }

  const std::vector<BoxNode>& binary_;
  WideTree tree_;
};

constexpr unsigned kAllLanes = (1U << kLanes) - 1U;

[[gnu::always_inline]] inline void load(const LaneNumbers& from, Floats8& to) {
  std::memcpy(&to, from.data(), sizeof to);
}

[[gnu::always_inline]] inline void store(const Floats8& from, LaneNumbers& to) {
  std::memcpy(to.data(), &from, sizeof from);
}

[[gnu::always_inline]] inline void take_size(Floats8& numbers) {
  Ints8 bits;
  std::memcpy(&bits, &numbers, sizeof bits);
  bits &= 0x7fffffff;
  std::memcpy(&numbers, &bits, sizeof bits);
}

// A bound that is no number is none.
[[gnu::always_inline]] inline void take_larger(const Floats8& other, Floats8& numbers) {
  numbers = other > numbers ? other : numbers;
}

// Adds the square of what is left of the distance of two centres along an axis, beyond the halves
// of both boxes.
[[gnu::always_inline]] inline void add_apart(const Floats8& between, const Floats8& half,
                                             const Floats8& other_half, Floats8& squared) {
  const Floats8 zero = {};
  Floats8 apart = between;
  take_size(apart);
  apart = apart - half - other_half;
  apart = apart > zero ? apart : zero;
  squared += apart * apart;
}

[[gnu::always_inline]] inline void squared_from(const WideDistance::Relative& r,
                                                const WideNode& node_a,
                                                const WideDistance::Placed& b, float enough,
                                                LaneNumbers& squared) {
  const Floats8 zero = {};
  Floats8 between[3];
  Floats8 half[3];
  Floats8 along_a = zero;
  for (std::size_t k = 0; k < 3; ++k) {
    Floats8 center;
    load(node_a.center[k], center);
    load(node_a.half[k], half[k]);
    between[k] = b.center_A[k] - center;
    add_apart(between[k], half[k], zero + (b.half_A[k] + r.rounding), along_a);
  }
  store(along_a, squared);
  if (bits_of(along_a > enough) == kAllLanes) return;
  Floats8 along_b = zero;
  for (std::size_t k = 0; k < 3; ++k) {
    const Floats8 turned = r.rotation[0][k] * between[0] + r.rotation[1][k] * between[1] +
                           r.rotation[2][k] * between[2];
    const Floats8 enclosing =
        r.sizes[0][k] * half[0] + r.sizes[1][k] * half[1] + r.sizes[2][k] * half[2];
    add_apart(turned, enclosing, zero + (b.box.half[k] + r.rounding), along_b);
  }
  take_larger(along_a, along_b);
  store(along_b, squared);
}

[[gnu::always_inline]] inline void squared_to(const WideDistance::Relative& r, const WideBox& a,
                                              const WideNode& node_b, float enough,
                                              WideDistance::PlacedNode& in_a,
                                              LaneNumbers& squared) {
  const Floats8 zero = {};
  Floats8 center[3];
  Floats8 half[3];
  for (std::size_t k = 0; k < 3; ++k) {
    load(node_b.center[k], center[k]);
    load(node_b.half[k], half[k]);
  }
  Floats8 between[3];
  Floats8 along_a = zero;
  for (std::size_t k = 0; k < 3; ++k) {
    const Floats8 center_A = r.rotation[k][0] * center[0] + r.rotation[k][1] * center[1] +
                             r.rotation[k][2] * center[2] + r.shift[k];
    const Floats8 half_A =
        r.sizes[k][0] * half[0] + r.sizes[k][1] * half[1] + r.sizes[k][2] * half[2];
    store(center_A, in_a.center_A[k]);
    store(half_A, in_a.half_A[k]);
    between[k] = center_A - a.center[k];
    add_apart(between[k], half_A, zero + (a.half[k] + r.rounding), along_a);
  }
  store(along_a, squared);
  if (bits_of(along_a > enough) == kAllLanes) return;
  Floats8 along_b = zero;
  for (std::size_t k = 0; k < 3; ++k) {
    const Floats8 turned = r.rotation[0][k] * between[0] + r.rotation[1][k] * between[1] +
                           r.rotation[2][k] * between[2];
    const float enclosing =
        r.sizes[0][k] * a.half[0] + r.sizes[1][k] * a.half[1] + r.sizes[2][k] * a.half[2];
    add_apart(turned, half[k], zero + (enclosing + r.rounding), along_b);
  }
  take_larger(along_a, along_b);
  store(along_b, squared);
}

[[gnu::always_inline]] inline void squared_beside(const WideNode& node_a,
                                                  const WideDistance::Prism& b, float rounding,
                                                  LaneNumbers& squared) {
  Floats8 center[3];
  Floats8 half[3];
  for (std::size_t k = 0; k < 3; ++k) {
    load(node_a.center[k], center[k]);
    load(node_a.half[k], half[k]);
  }
  Floats8 apart = {};
  for (const WideDistance::HalfSpace& side : b) {
    const Floats8 height = side.normal[0] * center[0] + side.normal[1] * center[1] +
                           side.normal[2] * center[2] - (side.height + rounding);
    const Floats8 below =
        side.sizes[0] * half[0] + side.sizes[1] * half[1] + side.sizes[2] * half[2];
    take_larger(height - below, apart);
  }
  store(apart * apart, squared);
}

PREHEND_FOR_AVX2 void squared_from_with_avx2(const WideDistance::Relative& r,
                                             const WideNode& node_a, const WideDistance::Placed& b,
                                             float enough, LaneNumbers& squared) {
  squared_from(r, node_a, b, enough, squared);
}

PREHEND_FOR_AVX2 void squared_to_with_avx2(const WideDistance::Relative& r, const WideBox& a,
                                           const WideNode& node_b, float enough,
                                           WideDistance::PlacedNode& in_a, LaneNumbers& squared) {
  squared_to(r, a, node_b, enough, in_a, squared);
}

PREHEND_FOR_AVX2 void squared_beside_with_avx2(const WideNode& node_a, const WideDistance::Prism& b,
                                               float rounding, LaneNumbers& squared) {
  squared_beside(node_a, b, rounding, squared);
}

// Appends the triangles below a node whose boxes meet the box.
void collect_below(const WideTree& tree, WideChild at, const WideBox& box,
                   std::vector<int>& triangles) {
  const WideNode& node = tree.nodes[index(at)];
  Floats8 apart = Floats8{} - std::numeric_limits<float>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    Floats8 between;
    Floats8 half;
    load(node.center[k], between);
    load(node.half[k], half);
    between -= box.center[k];
    take_size(between);
    take_larger(between - half - box.half[k], apart);
  }
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    // An empty lane, which has the root, is far away, but a box may be as large as that.
    if (apart[lane] > 0.0F || node.child[lane] == 0) continue;
    if (is_triangle(node.child[lane])) {
      triangles.push_back(~node.child[lane]);
    } else {
      collect_below(tree, node.child[lane], box, triangles);
    }
  }
}

}  // namespace

WideTree build_wide_tree(const std::vector<BoxNode>& binary) { return WideBuilder(binary).build(); }

// Each distance along an axis is the sum of three numbers, none larger than the radius and those of
// the box.
void collect_in_box(const WideTree& tree, const Bounds& box, std::vector<int>& triangles) {
  const BoxNode given{box.center(), 0.5 * box.size(), -1, -1};
  WideBox around = rounded(given, tree.origin);
  const double size = tree.radius + (given.center - tree.origin).norm() + given.half.norm();
  for (float& half : around.half) half += 4.0F * kHalfUnit * static_cast<float>(size);
  collect_below(tree, 0, around, triangles);
}

// The numbers in a distance along one axis are at most the sum S of both radii and the shift, times
// sqrt(3) for a bound of the rotated ones. Each is the sum of three products and a shift, of
// numbers that were rounded themselves, and the second distance rotates the first: fewer than 32
// roundings of at most half a unit in the last place of S.
WideDistance::WideDistance(const WideTree& a, const WideTree& b, const Pose& X_AB)
    : origin_(a.origin), has_avx2_(has_avx2()) {
  const Vector3 shift = X_AB * b.origin - a.origin;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto row = static_cast<Vector3::Index>(i);
    for (std::size_t j = 0; j < 3; ++j) {
      relative_.rotation[i][j] =
          static_cast<float>(X_AB.linear()(row, static_cast<Vector3::Index>(j)));
      relative_.sizes[i][j] = std::abs(relative_.rotation[i][j]);
    }
    relative_.shift[i] = static_cast<float>(shift[row]);
  }
  relative_.rounding = 32.0F * kHalfUnit * static_cast<float>(a.radius + b.radius + shift.norm());
}

WideDistance::Placed WideDistance::placed(const WideBox& b) const {
  Placed placed{b, {}, {}};
  for (std::size_t i = 0; i < 3; ++i) {
    placed.center_A[i] = relative_.shift[i];
    for (std::size_t j = 0; j < 3; ++j) {
      placed.center_A[i] += relative_.rotation[i][j] * b.center[j];
      placed.half_A[i] += relative_.sizes[i][j] * b.half[j];
    }
  }
  return placed;
}

LaneNumbers WideDistance::squared(const WideNode& node_a, const Placed& b, float enough) const {
  LaneNumbers squared;
  if (has_avx2_) {
    squared_from_with_avx2(relative_, node_a, b, enough, squared);
  } else {
    squared_from(relative_, node_a, b, enough, squared);
  }
  return squared;
}

LaneNumbers WideDistance::squared(const WideBox& a, const WideNode& node_b, float enough,
                                  PlacedNode& in_a) const {
  LaneNumbers squared;
  if (has_avx2_) {
    squared_to_with_avx2(relative_, a, node_b, enough, in_a, squared);
  } else {
    squared_to(relative_, a, node_b, enough, in_a, squared);
  }
  return squared;
}

WideDistance::HalfSpace WideDistance::half_space(const Vector3& point,
                                                 const Vector3& normal) const {
  HalfSpace half_space;
  for (std::size_t k = 0; k < 3; ++k) {
    half_space.normal[k] = static_cast<float>(normal[static_cast<Vector3::Index>(k)]);
    half_space.sizes[k] = std::abs(half_space.normal[k]);
  }
  half_space.height = static_cast<float>(normal.dot(point - origin_));
  return half_space;
}

WideDistance::Prism WideDistance::prism(const PlacedTriangle& b_in_a) const {
  const std::array<Vector3, 3>& c = b_in_a.corner;
  const Vector3& n = b_in_a.normal;
  const auto side = [&](std::size_t k) {
    return half_space(c[k], (c[(k + 1) % 3] - c[k]).cross(n).normalized());
  };
  return {half_space(c[0], n), half_space(c[0], -n), side(0), side(1), side(2)};
}

// Fewer roundings than in the distances above, of numbers that are not larger.
LaneNumbers WideDistance::squared(const WideNode& node_a, const Prism& b) const {
  LaneNumbers squared;
  if (has_avx2_) {
    squared_beside_with_avx2(node_a, b, relative_.rounding, squared);
  } else {
    squared_beside(node_a, b, relative_.rounding, squared);
  }
  return squared;
}

}  // namespace prehend
