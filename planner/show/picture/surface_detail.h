// What a picture needs of a mesh beyond its triangles: normals to shade with and edges to draw.
#pragma once

#include <array>
#include <vector>

#include "sim/shape/triangle_mesh.h"

namespace prehend {

// An edge of the surface, with the triangles at it. `second` is -1 on a border, and also where more
// than two triangles meet or where two are not oriented alike.
struct SurfaceEdge {
  int from = 0;  // vertices
  int to = 0;
  int first = 0;  // triangles
  int second = -1;
};

// Normals and edges of a mesh.
struct SurfaceDetail {
  // Unit normal of each triangle; zero for one without area.
  std::vector<Vector3> face_normals;
  // Unit normals at the corners of each triangle: the mean, by angle, of the faces around the
  // vertex that lean less than the crease angle from this one.
  std::vector<std::array<Vector3, 3>> corner_normals;
  std::vector<SurfaceEdge> edges;
};

// Computes them. Vertices at the same place count as one, so that a mesh of loose triangles is seen
// as a surface. Triangles without area have no part in the normals and edges. Vertices must be
// finite.
SurfaceDetail surface_detail(const TriangleMesh& mesh, double crease_angle);

}  // namespace prehend
