#include "sim/shape/wide_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "sim/base/index.h"

namespace prehend {
namespace {

using std::experimental::abs;
using std::experimental::all_of;
using std::experimental::max;

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
      WideBox box{{kFar, kFar, kFar}, {}, 0};
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

// Appends the triangles below a node whose boxes meet the box.
void collect_below(const WideTree& tree, WideChild at, const WideBox& box,
                   std::vector<int>& triangles) {
  const WideNode& node = tree.nodes[index(at)];
  Lanes apart(-std::numeric_limits<float>::infinity());
  for (std::size_t k = 0; k < 3; ++k) {
    const Lanes between = abs(load_lanes(node.center[k].data()) - box.center[k]);
    apart = max(apart, between - load_lanes(node.half[k].data()) - box.half[k]);
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
    : origin_(a.origin) {
  const Vector3 shift = X_AB * b.origin - a.origin;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto row = static_cast<Vector3::Index>(i);
    for (std::size_t j = 0; j < 3; ++j) {
      rotation_[i][j] = static_cast<float>(X_AB.linear()(row, static_cast<Vector3::Index>(j)));
      sizes_[i][j] = std::abs(rotation_[i][j]);
    }
    shift_[i] = static_cast<float>(shift[row]);
  }
  rounding_ = 32.0F * kHalfUnit * static_cast<float>(a.radius + b.radius + shift.norm());
}

WideDistance::Placed WideDistance::placed(const WideBox& b) const {
  Placed placed{b, {}, {}};
  for (std::size_t i = 0; i < 3; ++i) {
    placed.center_A[i] = shift_[i];
    for (std::size_t j = 0; j < 3; ++j) {
      placed.center_A[i] += rotation_[i][j] * b.center[j];
      placed.half_A[i] += sizes_[i][j] * b.half[j];
    }
  }
  return placed;
}

// The squares of what is left of the distance of two centres, beyond the halves of both boxes.
Lanes WideDistance::squared(const WideNode& node_a, const Placed& b, float enough) const {
  const Lanes zero(0.0F);
  std::array<Lanes, 3> between;
  std::array<Lanes, 3> half;
  Lanes along_a = zero;
  for (std::size_t k = 0; k < 3; ++k) {
    between[k] = b.center_A[k] - load_lanes(node_a.center[k].data());
    half[k] = load_lanes(node_a.half[k].data());
    const Lanes apart = max(abs(between[k]) - half[k] - (b.half_A[k] + rounding_), zero);
    along_a += apart * apart;
  }
  if (all_of(along_a > enough)) return along_a;
  Lanes along_b = zero;
  for (std::size_t k = 0; k < 3; ++k) {
    const Lanes turned =
        rotation_[0][k] * between[0] + rotation_[1][k] * between[1] + rotation_[2][k] * between[2];
    const Lanes enclosing =
        sizes_[0][k] * half[0] + sizes_[1][k] * half[1] + sizes_[2][k] * half[2];
    const Lanes apart = max(abs(turned) - enclosing - (b.box.half[k] + rounding_), zero);
    along_b += apart * apart;
  }
  return max(along_a, along_b);
}

Lanes WideDistance::squared(const WideBox& a, const WideNode& node_b, float enough,
                            PlacedNode& in_a) const {
  const Lanes zero(0.0F);
  std::array<Lanes, 3> center;
  std::array<Lanes, 3> half;
  for (std::size_t k = 0; k < 3; ++k) {
    center[k] = load_lanes(node_b.center[k].data());
    half[k] = load_lanes(node_b.half[k].data());
  }
  std::array<Lanes, 3> between;
  Lanes along_a = zero;
  for (std::size_t k = 0; k < 3; ++k) {
    in_a.center_A[k] = rotation_[k][0] * center[0] + rotation_[k][1] * center[1] +
                       rotation_[k][2] * center[2] + shift_[k];
    in_a.half_A[k] = sizes_[k][0] * half[0] + sizes_[k][1] * half[1] + sizes_[k][2] * half[2];
    between[k] = in_a.center_A[k] - a.center[k];
    const Lanes apart = max(abs(between[k]) - in_a.half_A[k] - (a.half[k] + rounding_), zero);
    along_a += apart * apart;
  }
  if (all_of(along_a > enough)) return along_a;
  Lanes along_b = zero;
  for (std::size_t k = 0; k < 3; ++k) {
    const Lanes turned =
        rotation_[0][k] * between[0] + rotation_[1][k] * between[1] + rotation_[2][k] * between[2];
    const float enclosing =
        sizes_[0][k] * a.half[0] + sizes_[1][k] * a.half[1] + sizes_[2][k] * a.half[2];
    const Lanes apart = max(abs(turned) - half[k] - (enclosing + rounding_), zero);
    along_b += apart * apart;
  }
  return max(along_a, along_b);
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
Lanes WideDistance::squared(const WideNode& node_a, const Prism& b) const {
  const std::array<Lanes, 3> center{load_lanes(node_a.center[0].data()),
                                    load_lanes(node_a.center[1].data()),
                                    load_lanes(node_a.center[2].data())};
  const std::array<Lanes, 3> half{load_lanes(node_a.half[0].data()),
                                  load_lanes(node_a.half[1].data()),
                                  load_lanes(node_a.half[2].data())};
  Lanes apart(0.0F);
  for (const HalfSpace& side : b) {
    const Lanes height = side.normal[0] * center[0] + side.normal[1] * center[1] +
                         side.normal[2] * center[2] - (side.height + rounding_);
    const Lanes below = side.sizes[0] * half[0] + side.sizes[1] * half[1] + side.sizes[2] * half[2];
    apart = max(apart, height - below);
  }
  return apart * apart;
}

}  // namespace prehend
