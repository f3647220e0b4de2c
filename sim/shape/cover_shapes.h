// A few simple convex shapes around a surface, and balls inside it, for collision checks of many
// postures at once.
#pragma once

#include <vector>

#include "sim/base/pose.h"

namespace prehend {

struct BoxNode;       // box_tree.h
class ProximityMesh;  // proximity_mesh.h

// A box, a cylinder along z or a capsule along z, each about the origin of its frame S [m]: the sum
// of the box |p| <= half, of a disc in the plane of x and y and of a ball.
struct CoverShape {
  Pose X_MS = Pose::Identity();  // in the frame of the mesh
  Vector3 half = Vector3::Zero();
  double disc = 0.0;  // radius
  double ball = 0.0;  // radius
  // The shape, scaled by this about its centre, lies in the solid that the mesh bounds; 0: none
  // does.
  double inside = 0.0;

  // How far the shape reaches from its centre along the unit vector `n_S`.
  double extent(const Vector3& n_S) const;
};

// A ball in the solid that a mesh bounds, in the mesh's frame [m]; of radius 0: a corner of it.
struct InnerBall {
  Vector3 center = Vector3::Zero();
  double radius = 0.0;
};

// What stands for a mesh in its frame.
struct ShapeCover {
  std::vector<CoverShape> shapes;  // each triangle is in one of them
  std::vector<InnerBall> inside;   // some that fill it, and corners
};

// A shape for each connected component where these fill their shapes well, else boxes around parts
// of the surface. `tree` is that of build_box_tree for the mesh.
ShapeCover make_cover(const ProximityMesh& mesh, const std::vector<BoxNode>& tree);

// That of a mesh, made when it is first asked for.
const ShapeCover& cover_of(const ProximityMesh& mesh);

}  // namespace prehend
