// The walk over the trees of two meshes that all distance queries share.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <limits>

#include "sim/base/index.h"
#include "sim/base/wide_lanes.h"
#include "sim/shape/triangle_distance.h"
#include "sim/shape/wide_tree.h"

namespace prehend {

// Traverses both trees at once, nearer pairs first, so that small distances are found early and
// prune the rest. `Visitor` has:
// double wanted() const         squared distance [m^2] above which pairs are unwanted; negative:
//                               no more pairs are wanted
// void left_out(double squared) called with a lower bound of the squared distance of pairs of boxes
//                               that are left out
// const PlacedTriangle& triangle_b(int b)  the triangle in the frame of the first mesh
// void visit(int a, int b)      called for pairs of triangles
template <typename Visitor>
class TreeWalk {
 public:
  TreeWalk(const WideTree& a, const WideTree& b, const Pose& X_AB, Visitor& visitor)
      : a_(a), b_(b), distance_(a, b, X_AB), visitor_(visitor) {}

  void run() {
    note_wanted();
    descend(a_.root, distance_.placed(b_.root), nullptr);
  }

 private:
  using Placed = WideDistance::Placed;
  using Prism = WideDistance::Prism;

  // The lanes that are wanted, nearest first.
  struct Wanted {
    std::array<std::size_t, kLanes> lane;
    std::size_t count = 0;
  };

  // Sorts wanted lanes in; the nearest of the others is reported.
  Wanted wanted_lanes(const LaneNumbers& squared) {
    Floats8 numbers;
    std::memcpy(&numbers, squared.data(), sizeof numbers);
    // A bound that is no number is of no triangle: to go on with it would never end.
    const unsigned bits = bits_of(numbers <= wanted_);
    Wanted wanted;
    for (unsigned left = bits; left != 0; left &= left - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(left));
      std::size_t place = wanted.count++;
      for (; place > 0 && squared[wanted.lane[place - 1]] > squared[lane]; --place) {
        wanted.lane[place] = wanted.lane[place - 1];
      }
      wanted.lane[place] = lane;
    }
    if (wanted.count < kLanes) {
      float nearest_left_out = std::numeric_limits<float>::infinity();
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        const bool is_left_out = (bits >> lane & 1U) == 0;
        if (is_left_out && squared[lane] < nearest_left_out) nearest_left_out = squared[lane];
      }
      leave_out(nearest_left_out);
    }
    return wanted;
  }

  // A bound in single precision may exceed the square that it stands for by its last bits.
  void leave_out(float squared) { visitor_.left_out(0.999999 * static_cast<double>(squared)); }

  // What is wanted, in single precision and not below the visitor's own. It changes with visits.
  void note_wanted() { wanted_ = 1.000001F * static_cast<float>(visitor_.wanted()); }

  // `prism`: that of b where it is a triangle, null where it is not known yet.
  void descend(const WideBox& a, const Placed& b, const Prism* prism) {
    const bool a_ends = is_triangle(a.child);
    const bool b_ends = is_triangle(b.box.child);
    if (a_ends && b_ends) {
      visitor_.visit(~a.child, ~b.box.child);
      note_wanted();
    } else if (b_ends && prism == nullptr && size_of(b.box) > kLarge * size_of(a)) {
      const Prism own = distance_.prism(visitor_.triangle_b(~b.box.child));
      into_a(a_.nodes[index(a.child)], b, &own);
    } else if (b_ends || (!a_ends && size_of(a) > size_of(b.box))) {
      // Into the larger box: its children improve the bound the most.
      into_a(a_.nodes[index(a.child)], b, prism);
    } else {
      into_b(a, b_.nodes[index(b.box.child)]);
    }
  }

  // Of sizes (squares): a triangle whose box is four times as large as another box may be far from
  // it though the boxes meet. For smaller ones its prism does not pay.
  static constexpr float kLarge = 16.0F;

  static float size_of(const WideBox& box) {
    return box.half[0] * box.half[0] + box.half[1] * box.half[1] + box.half[2] * box.half[2];
  }

  static WideBox box_of(const WideNode& node, std::size_t lane) {
    return {{node.center[0][lane], node.center[1][lane], node.center[2][lane]},
            {node.half[0][lane], node.half[1][lane], node.half[2][lane]},
            node.child[lane]};
  }

  // The box of a large triangle that is aligned with no axis is mostly empty. Many boxes of a fine
  // mesh may be in it that are far from the triangle, which its prism shows.
  void into_a(const WideNode& node, const Placed& b, const Prism* prism) {
    LaneNumbers squared = distance_.squared(node, b, wanted_);
    if (prism != nullptr) {
      const LaneNumbers beside = distance_.squared(node, *prism);
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        squared[lane] = std::max(squared[lane], beside[lane]);
      }
    }
    const Wanted wanted = wanted_lanes(squared);
    for (std::size_t i = 0; i < wanted.count; ++i) {
      const std::size_t lane = wanted.lane[i];
      // What is wanted may have become less.
      if (squared[lane] > wanted_) {
        leave_out(squared[lane]);
      } else {
        descend(box_of(node, lane), b, prism);
      }
    }
  }

  void into_b(const WideBox& a, const WideNode& node) {
    WideDistance::PlacedNode in_a;
    const LaneNumbers squared = distance_.squared(a, node, wanted_, in_a);
    const Wanted wanted = wanted_lanes(squared);
    for (std::size_t i = 0; i < wanted.count; ++i) {
      const std::size_t lane = wanted.lane[i];
      if (squared[lane] > wanted_) {
        leave_out(squared[lane]);
        continue;
      }
      Placed b{box_of(node, lane), {}, {}};
      for (std::size_t k = 0; k < 3; ++k) {
        b.center_A[k] = in_a.center_A[k][lane];
        b.half_A[k] = in_a.half_A[k][lane];
      }
      descend(a, b, nullptr);
    }
  }

  const WideTree& a_;
  const WideTree& b_;
  const WideDistance distance_;
  Visitor& visitor_;
  float wanted_ = 0.0F;
};

}  // namespace prehend
