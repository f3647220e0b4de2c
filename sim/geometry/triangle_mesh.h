// A triangle mesh as a value: points and index triples, nothing else.
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "sim/base/pose.h"

namespace prehend {

// Indices of its three vertices.
using Triangle = std::array<int, 3>;

// Vertices in metres in the body's frame; triangles counter-clockwise seen from outside.
struct TriangleMesh {
  std::vector<Vector3> vertices;
  std::vector<Triangle> triangles;

  bool empty() const { return triangles.empty(); }
};

// A box along the axes, from its lower to its upper corner [m].
struct Bounds {
  Vector3 lower = Vector3::Constant(std::numeric_limits<double>::infinity());
  Vector3 upper = Vector3::Constant(-std::numeric_limits<double>::infinity());

  Vector3 size() const { return upper - lower; }
  Vector3 center() const { return 0.5 * (lower + upper); }
  // Its length.
  double diagonal() const { return size().norm(); }
};

// Axis-aligned bounds of the vertices; lower > upper for a mesh without vertices.
Bounds bounds(const TriangleMesh& mesh);

// Twice the area of triangle `t`, along its outward normal (right-hand rule) [m^2].
Vector3 doubled_area_vector(const TriangleMesh& mesh, std::size_t t);

// Sum of the areas of its triangles [m^2].
double surface_area(const TriangleMesh& mesh);

// The mesh with every vertex moved by `X_AB` (from frame B to frame A).
TriangleMesh transformed(const TriangleMesh& mesh, const Pose& X_AB);

// Appends `part` to `mesh`; the parts stay separate components.
void append(TriangleMesh& mesh, const TriangleMesh& part);

// Largest distance of a vertex from `point` (mesh frame); 0 without vertices [m].
double max_distance(const TriangleMesh& mesh, const Vector3& point);

}  // namespace prehend
