// The frame of an object that its surface determines, so that it turns and moves with the object.
#pragma once

#include "sim/base/pose.h"
#include "sim/shape/triangle_mesh.h"

namespace prehend {

// Frame A of an object whose mesh is given in O.
struct OwnFrame {
  Pose X_OA = Pose::Identity();
  // Of the box around the triangles along the axes of A: its middle in A [m] and its diagonal [m].
  Vector3 center_A = Vector3::Zero();
  double diagonal = 0.0;
};

// The origin is the centre of the surface's area, the axes are the principal axes of its second
// moments, least first, and the first two point to where the surface reaches farther (third
// moments). All are exact integrals over the triangles. Where moments are equal, as those of a can
// or a cube, the largest flat part of the surface decides, and where parts are alike the order of
// triangles, which turning the object does not change. Requires valid
// indices and finite vertices; without area the axes are those of O and the diagonal is 0.
OwnFrame own_frame(const TriangleMesh& mesh);

}  // namespace prehend
