#include "sim/shape/ray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "sim/base/index.h"
#include "sim/shape/triangle_distance.h"
#include "sim/shape/wide_tree.h"

namespace prehend {
namespace {

// Walks down a tree, nearer boxes first.
class RayWalk {
 public:
  RayWalk(const WideTree& tree, const std::vector<PlacedTriangle>& triangles, const Vector3& from,
          const Vector3& direction, double cap)
      : tree_(tree), triangles_(triangles), from_(from), direction_(direction) {
    hit_.distance = cap;
    // Boxes are wider by the rounding of what is computed from them in single precision.
    const Vector3 start = from - tree.origin;
    margin_ = 4e-7F * static_cast<float>(tree.radius + start.norm());
    for (std::size_t k = 0; k < 3; ++k) {
      const double along = direction[static_cast<Vector3::Index>(k)];
      const bool flat = std::abs(along) < 1e-9;
      from_near_[k] = static_cast<float>(start[static_cast<Vector3::Index>(k)]);
      inverse_[k] = static_cast<float>(1.0 / (flat ? std::copysign(1e-9, along) : along));
    }
  }

  RayHit run() {
    descend(0);
    if (hit_.triangle < 0) hit_.distance = std::numeric_limits<double>::infinity();
    return hit_;
  }

 private:
  void descend(int node_number) {
    const WideNode& node = tree_.nodes[index(node_number)];
    LaneNumbers enter;
    const auto wanted = wanted_lanes(node, enter);
    for (std::size_t i = 0; i < wanted.count; ++i) {
      const std::size_t lane = wanted.lane[i];
      if (static_cast<double>(enter[lane]) > hit_.distance) return;
      const WideChild child = node.child[lane];
      if (is_triangle(child)) {
        meet(~child);
      } else {
        descend(child);
      }
    }
  }

  // The lanes whose boxes the ray meets, nearest first.
  struct Wanted {
    std::array<std::size_t, kLanes> lane;
    std::size_t count = 0;
  };

  Wanted wanted_lanes(const WideNode& node, LaneNumbers& enter) const {
    LaneNumbers leave;
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      float first = 0.0F;
      float last = std::numeric_limits<float>::infinity();
      for (std::size_t k = 0; k < 3; ++k) {
        const float to_center = node.center[k][lane] - from_near_[k];
        const float half = node.half[k][lane] + margin_;
        const float a = (to_center - half) * inverse_[k];
        const float b = (to_center + half) * inverse_[k];
        first = std::max(first, std::min(a, b));
        last = std::min(last, std::max(a, b));
      }
      enter[lane] = first;
      leave[lane] = last;
    }
    Wanted wanted;
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      enter[lane] *= 1.0F - 1e-6F;
      // A lane without a child has a box of negative size.
      if (node.half[0][lane] < 0.0F || enter[lane] > leave[lane] * (1.0F + 1e-6F)) continue;
      if (static_cast<double>(enter[lane]) > hit_.distance) continue;
      std::size_t place = wanted.count++;
      for (; place > 0 && enter[wanted.lane[place - 1]] > enter[lane]; --place) {
        wanted.lane[place] = wanted.lane[place - 1];
      }
      wanted.lane[place] = lane;
    }
    return wanted;
  }

  // Moeller and Trumbore 1997, "Fast, minimum storage ray/triangle intersection".
  void meet(int t) {
    const std::array<Vector3, 3>& corner = triangles_[index(t)].corner;
    const Vector3 u = corner[1] - corner[0];
    const Vector3 v = corner[2] - corner[0];
    const Vector3 across = direction_.cross(v);
    const double determinant = u.dot(across);
    if (determinant == 0.0) return;
    const Vector3 s = from_ - corner[0];
    const double a = s.dot(across) / determinant;
    if (!(a >= 0.0 && a <= 1.0)) return;
    const Vector3 q = s.cross(u);
    const double b = direction_.dot(q) / determinant;
    if (!(b >= 0.0 && a + b <= 1.0)) return;
    const double distance = v.dot(q) / determinant;
    if (!(distance >= 0.0 && distance < hit_.distance)) return;
    hit_ = {distance, t};
  }

  const WideTree& tree_;
  const std::vector<PlacedTriangle>& triangles_;
  const Vector3 from_;
  const Vector3 direction_;
  std::array<float, 3> from_near_{};
  std::array<float, 3> inverse_{};
  float margin_ = 0.0F;
  RayHit hit_;
};

}  // namespace

RayHit first_hit(const WideTree& tree, const std::vector<PlacedTriangle>& triangles,
                 const Vector3& from, const Vector3& direction, double cap) {
  return RayWalk(tree, triangles, from, direction, cap).run();
}

}  // namespace prehend
