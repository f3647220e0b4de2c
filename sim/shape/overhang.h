// How far a convex shape reaches out of a solid.
#pragma once

#include <vector>

#include "sim/base/run_context.h"
#include "sim/shape/box_tree.h"
#include "sim/shape/triangle_mesh.h"
#include "sim/shape/winding_number.h"

namespace prehend {

// A point of a shape that is outside the solid, and the point of the solid nearest to it.
struct OverhangPoint {
  Vector3 position = Vector3::Zero();
  Vector3 nearest = Vector3::Zero();
  double distance = 0.0;  // between them [m]
};

// A solid made ready to be asked for overhangs. It is what its mesh winds around; a mesh that
// bounds nothing is a surface only.
class OverhangGauge {
 public:
  // Throws InputError for a mesh without triangles, and Cancelled.
  explicit OverhangGauge(TriangleMesh solid, const RunContext& context = {});

  const TriangleMesh& solid() const { return solid_; }

  bool contains(const Vector3& p) const;

  // The point of the surface nearest to a point, whether or not that is inside.
  OverhangPoint nearest(const Vector3& p) const;

  // Points of the faces of `hull`, about `samples` of them spread over its area, that are outside
  // the solid and farther than `tolerance` [m] from it; the farthest first.
  std::vector<OverhangPoint> find(const TriangleMesh& hull, double tolerance, int samples) const;

 private:
  TriangleMesh solid_;
  std::vector<BoxNode> tree_;
  BoundaryTree boundaries_;
};

}  // namespace prehend
