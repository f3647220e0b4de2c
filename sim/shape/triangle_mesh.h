// A triangle mesh as a plain value: vertices and index triples.
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "sim/base/pose.h"

namespace prehend {

// Indices of the three vertices of a triangle.
using Triangle = std::array<int, 3>;

// Vertices [m] in the body's frame; triangles are counter-clockwise seen from outside.
struct TriangleMesh {
  std::vector<Vector3> vertices;
  std::vector<Triangle> triangles;

  bool empty() const { return triangles.empty(); }
};

// An axis-aligned box [m]. The default is empty (lower > upper).
struct Bounds {
  Vector3 lower = Vector3::Constant(std::numeric_limits<double>::infinity());
  Vector3 upper = Vector3::Constant(-std::numeric_limits<double>::infinity());

  Vector3 size() const { return upper - lower; }
  Vector3 center() const { return 0.5 * (lower + upper); }
  // Length of the diagonal.
  double diagonal() const { return size().norm(); }
};

// Axis-aligned bounds of the vertices; lower > upper for a mesh without vertices.
Bounds bounds(const TriangleMesh& mesh);

// The corners of a triangle, in the frame of its mesh.
using Corners = std::array<Vector3, 3>;
Corners corners_of(const TriangleMesh& mesh, int triangle);

// The normal of triangle `t` by the right-hand rule, with twice the area of the triangle as length
// [m^2]. It points outward.
Vector3 doubled_area_vector(const TriangleMesh& mesh, std::size_t t);

// Sum of the areas of all triangles [m^2].
double surface_area(const TriangleMesh& mesh);

// The mesh, given in frame B, expressed in frame A.
TriangleMesh transformed(const TriangleMesh& mesh, const Pose& X_AB);

// Appends the vertices and triangles of `part` to `mesh` without joining them.
void append(TriangleMesh& mesh, const TriangleMesh& part);

// As append, of `part` in a frame B that `X_AB` places in the frame A of `mesh`. A transform that
// mirrors would reverse the winding: the triangles are turned back.
void append(TriangleMesh& mesh, const TriangleMesh& part, const Eigen::Affine3d& X_AB);

// Largest distance of a vertex from `point` (mesh frame) [m]; 0 without vertices.
double max_distance(const TriangleMesh& mesh, const Vector3& point);

}  // namespace prehend
