// Bounding-volume hierarchy of axis-aligned boxes over the triangles of a mesh, and a lower bound
// of the distance between two boxes.
#pragma once

#include <algorithm>
#include <vector>

#include "sim/base/run_context.h"
#include "sim/geometry/triangle_mesh.h"

namespace prehend {

// The box |p - center| <= half, component by component, in the frame of the mesh [m].
struct BoxNode {
  Vector3 center = Vector3::Zero();
  Vector3 half = Vector3::Zero();
  int left = -1;      // index of the first child, the second follows it; -1: a leaf
  int triangle = -1;  // the only triangle of a leaf

  bool is_leaf() const { return left < 0; }
};

// Builds the tree, one triangle per leaf; node 0 is the root. A node is split at the median of the
// centroids of its triangles along the longest side of their bounds. Empty for an empty mesh.
// Throws Cancelled.
std::vector<BoxNode> build_box_tree(const TriangleMesh& mesh, const RunContext& context = {});

// Lower bound of the distance between boxes of two meshes a and b at a fixed relative pose.
//
// Each box is enclosed in a box aligned with the axes of the other; both distances between aligned
// boxes are lower bounds, and the larger one is returned. These are 6 of the 15 axes of the
// separating-axis test (Gottschalk, Lin and Manocha 1996): the bound may be 0 for boxes that are
// apart, which costs only time.
class BoxDistance {
 public:
  // X_AB: the pose of mesh b's frame in mesh a's frame.
  explicit BoxDistance(const Pose& X_AB)
      : rotation_(X_AB.linear()), sizes_(X_AB.linear().cwiseAbs()), shift_(X_AB.translation()) {}

  // A box of mesh b in a's frame: its centre, and half the box along a's axes that encloses it. The
  // walk over two trees keeps it while it goes through boxes of a.
  struct Placed {
    Vector3 center;
    Vector3 half;
  };
  Placed placed(const BoxNode& b) const { return {rotation_ * b.center + shift_, sizes_ * b.half}; }

  // Squared lower bound [m^2]. The second of the two distances costs most and is left out where the
  // first exceeds `enough` already. `in_a` is `b` placed.
  double squared(const BoxNode& a, const BoxNode& b, const Placed& in_a, double enough) const {
    const Vector3 between = in_a.center - a.center;
    const double along_a =
        (between.cwiseAbs() - a.half - in_a.half).cwiseMax(Vector3::Zero()).squaredNorm();
    if (along_a > enough) return along_a;
    const double along_b =
        ((rotation_.transpose() * between).cwiseAbs() - b.half - sizes_.transpose() * a.half)
            .cwiseMax(Vector3::Zero())
            .squaredNorm();
    return std::max(along_a, along_b);
  }

 private:
  Matrix3 rotation_;
  Matrix3 sizes_;
  Vector3 shift_;
};

}  // namespace prehend
