// The axes of fitted primitives: onto those of the object where they nearly are, and chosen by the
// object where the shape leaves them open.
#pragma once

#include "sim/shape/primitive.h"
#include "sim/shape/triangle_mesh.h"

namespace prehend {

// Where the surface of a mesh is: integrals over its area, of 1, p and p p^T.
struct SurfaceMoments {
  double area = 0.0;
  Vector3 first = Vector3::Zero();
  Matrix3 second = Matrix3::Zero();
};

SurfaceMoments surface_moments(const TriangleMesh& mesh);

// The primitive with its middle and its size, and of a cylinder x, any direction across its axis,
// turned to the one in which the surface spreads most, seen from that axis: of the body of a cup
// the direction of its handle. Where it spreads alike in all of them, it is the frame's axis most
// nearly across. Grasps are proposed from x on in steps of a turn, so that they come in line with
// what is not symmetric in the object, whatever the sample points were.
Primitive aligned(const Primitive& primitive, const SurfaceMoments& surface);

// The primitive with axes along those of its frame where they are within a tenth of a degree.
// Objects are mostly modelled along their frame.
Primitive along_frame(const Primitive& primitive);

}  // namespace prehend
