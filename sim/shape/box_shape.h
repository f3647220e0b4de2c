// Whether a convex mesh is a box.
#pragma once

#include <optional>

#include "sim/shape/triangle_mesh.h"

namespace prehend {

// A box around the origin of frame B, its edges along the axes.
struct PlacedBox {
  Pose X_MB = Pose::Identity();    // in the frame of the mesh
  Vector3 size = Vector3::Zero();  // m
};

// The box that the convex closed mesh is; nothing where its volume differs from that of the box
// around it, along its largest faces, by more than a millionth.
std::optional<PlacedBox> box_shape(const TriangleMesh& convex);

}  // namespace prehend
