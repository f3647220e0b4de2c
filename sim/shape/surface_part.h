// Part of a surface: convex polygons, which planes cut.
#pragma once

#include <array>
#include <vector>

#include "sim/shape/triangle_mesh.h"

namespace prehend {

// The points p with normal . p = offset; normal is of unit length.
struct CutPlane {
  Vector3 normal = Vector3::UnitZ();
  double offset = 0.0;  // m

  double height(const Vector3& p) const { return normal.dot(p) - offset; }
};

// Convex polygons, one after the other in `corners`; ends[k] is where polygon k ends.
struct SurfacePart {
  std::vector<Vector3> corners;
  std::vector<std::size_t> ends;

  bool empty() const { return ends.empty(); }
};

SurfacePart surface_part(const TriangleMesh& mesh);

// What lies below the plane and what lies above it. Polygons in the plane belong to the side that
// they face away from, where the solid is. Two polygons that share an edge get the same point where
// it is cut, to the bit.
std::array<SurfacePart, 2> cut(const SurfacePart& part, const CutPlane& plane);

// The points of both sides: corners, and those where the plane cuts edges. Of more than `most`
// polygons only that many are looked at, spread over the part.
std::array<std::vector<Vector3>, 2> cut_points(const SurfacePart& part, const CutPlane& plane,
                                               std::size_t most);

// The part in pieces whose bounding boxes do not overlap, each made of polygons that share corners,
// in the order of their first polygons. Nested surfaces, such as the two sides of a wall, stay
// together.
std::vector<SurfacePart> separate_parts(const SurfacePart& part);

}  // namespace prehend
