// Bounding-volume hierarchy for walks over two meshes at once: eight children to a node, whose
// boxes are compared in one step (sim/base/wide_lanes.h), in single precision.
#pragma once

#include <array>
#include <vector>

#include "sim/shape/box_tree.h"
#include "sim/shape/triangle_distance.h"
#include "sim/shape/triangle_mesh.h"

namespace prehend {

inline constexpr std::size_t kLanes = 8;
// A number for each box of a node.
using LaneNumbers = std::array<float, kLanes>;

// What is below a box: a node (>= 0), or the triangle ~child (< 0).
using WideChild = int;
constexpr bool is_triangle(WideChild child) { return child < 0; }

// The boxes of the children, each |p - center| <= half, component by component. Coordinates are
// relative to WideTree::origin [m]. A lane without a child has a box that is farther away than
// anything, of negative size.
struct WideNode {
  std::array<LaneNumbers, 3> center;
  std::array<LaneNumbers, 3> half;
  std::array<WideChild, kLanes> child;
};

// One box of a node.
struct WideBox {
  std::array<float, 3> center{};
  std::array<float, 3> half{};
  WideChild child = 0;
};

struct WideTree {
  std::vector<WideNode> nodes;  // the first is the root
  WideBox root;                 // around all, its child is node 0
  // Boxes are relative to the middle of the mesh, where single precision is finest.
  Vector3 origin = Vector3::Zero();
  double radius = 0.0;  // no box reaches farther from the origin [m]
};

// Merges levels of the tree of build_box_tree. Boxes are rounded outward. `binary` must not be
// empty.
WideTree build_wide_tree(const std::vector<BoxNode>& binary);

// Appends the triangles whose boxes meet `box`, given in the frame of the mesh. Rounding errs on
// the side of triangles that miss it.
void collect_in_box(const WideTree& tree, const Bounds& box, std::vector<int>& triangles);

// Lower bounds of the distance between boxes of two trees a and b at a fixed relative pose.
//
// Each box is enclosed in a box aligned with the axes of the other; both distances between aligned
// boxes are lower bounds, and the larger one is returned. These are 6 of the 15 axes of the
// separating-axis test (Gottschalk, Lin and Manocha 1996): the bound may be 0 for boxes that are
// apart, which costs only time. Single precision is accounted for: bounds are proven.
class WideDistance {
 public:
  // X_AB: the pose of mesh b's frame in mesh a's frame.
  WideDistance(const WideTree& a, const WideTree& b, const Pose& X_AB);

  // A box of b, and where it is in a: its centre, and half the box along a's axes that encloses it.
  struct Placed {
    WideBox box;
    std::array<float, 3> center_A{};
    std::array<float, 3> half_A{};
  };
  Placed placed(const WideBox& b) const;

  // Squared lower bounds [m^2] of the distances between `b` and the boxes of a node of a. The
  // second of the two distances costs most and is left out where the first exceeds `enough` in all
  // lanes already.
  LaneNumbers squared(const WideNode& node_a, const Placed& b, float enough) const;
  // The same for the boxes of a node of b, and where they are in a.
  struct PlacedNode {
    std::array<LaneNumbers, 3> center_A;
    std::array<LaneNumbers, 3> half_A;
  };
  LaneNumbers squared(const WideBox& a, const WideNode& node_b, float enough,
                      PlacedNode& in_a) const;

  // A half-space in a's frame: the points with normal . p <= height, from the origin of the tree.
  struct HalfSpace {
    std::array<float, 3> normal{};
    std::array<float, 3> sizes{};  // absolute values of the normal
    float height = 0.0F;
  };
  // The prism over a triangle: between its plane from both sides, and within its edges.
  using Prism = std::array<HalfSpace, 5>;
  // That of a triangle of b that is given in a's frame. One without a normal has no bounds.
  Prism prism(const PlacedTriangle& b_in_a) const;
  // Squared lower bounds [m^2] of the distances between the triangle and the boxes of a node of a.
  LaneNumbers squared(const WideNode& node_a, const Prism& b) const;

  // How b lies in a, in single precision.
  struct Relative {
    std::array<std::array<float, 3>, 3> rotation{};  // R_AB
    std::array<std::array<float, 3>, 3> sizes{};     // its absolute values
    std::array<float, 3> shift{};                    // origin of b from that of a, in a
    float rounding = 0.0F;                           // bound of the error of a distance [m]
  };

 private:
  HalfSpace half_space(const Vector3& point, const Vector3& normal) const;

  Vector3 origin_;  // of tree a
  Relative relative_;
  bool has_avx2_;
};

}  // namespace prehend
