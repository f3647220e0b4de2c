// A binary tree of boxes around the triangles of a mesh.
#pragma once

#include <algorithm>
#include <vector>

#include "sim/base/run_context.h"
#include "sim/geometry/triangle_mesh.h"

namespace prehend {

// The set |p - center| <= half, axis by axis, in the mesh's frame.
struct BoxNode {
  Vector3 center = Vector3::Zero();
  Vector3 half = Vector3::Zero();
  int left = -1;      // children left and left + 1; -1 for a leaf
  int triangle = -1;  // of a leaf

  bool is_leaf() const { return left < 0; }
};

// Node 0 is the root. Splits at the median along the longest side of the triangles' centres.
// Throws Cancelled.
std::vector<BoxNode> build_box_tree(const TriangleMesh& mesh, const RunContext& context = {});

// Lower bound of the distance between boxes of two meshes at one relative pose.
class BoxDistance {
 public:
  // X_AB: the pose of mesh b's frame in mesh a's frame.
  explicit BoxDistance(const Pose& X_AB)
      : rotation_(X_AB.linear()), sizes_(X_AB.linear().cwiseAbs()), shift_(X_AB.translation()) {}

  // Squared distance between each box and the axis-aligned box, in its frame, around the other; the
  // larger of the two.
  double squared(const BoxNode& a, const BoxNode& b) const {
    const Vector3 between = rotation_ * b.center + shift_ - a.center;
    const Vector3 in_a = (between.cwiseAbs() - a.half - sizes_ * b.half).cwiseMax(Vector3::Zero());
    const Vector3 in_b =
        ((rotation_.transpose() * between).cwiseAbs() - b.half - sizes_.transpose() * a.half)
            .cwiseMax(Vector3::Zero());
    return std::max(in_a.squaredNorm(), in_b.squaredNorm());
  }

 private:
  Matrix3 rotation_;
  Matrix3 sizes_;
  Vector3 shift_;
};

}  // namespace prehend
