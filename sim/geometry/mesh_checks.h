// What is right and wrong with a mesh: counts that decide what can be trusted.
#pragma once

#include "sim/geometry/triangle_mesh.h"

namespace prehend {

struct MeshChecks {
  int vertices = 0;
  int triangles = 0;
  int components = 0;          // sets of triangles connected by shared vertices
  int boundary_edges = 0;      // edges of exactly one triangle
  int nonmanifold_edges = 0;   // edges of three or more triangles
  int misoriented_edges = 0;   // edges of two triangles that run through it in the same direction
  int degenerate_triangles = 0;
  bool inward = false;         // closed and oriented, but the signed volume is negative

  // Every edge in exactly two triangles.
  bool closed() const { return triangles > 0 && boundary_edges == 0 && nonmanifold_edges == 0; }
  // Closed, and neighbours agree on outside: the signed volume means something.
  bool solid() const { return closed() && misoriented_edges == 0; }
};

MeshChecks check_mesh(const TriangleMesh& mesh);

// Makes neighbours agree on orientation where the surface allows it and turns every closed
// component outward; open components are turned so that most of their area faces away from their
// centroid. Returns the number of triangles turned.
int orient_outward(TriangleMesh& mesh);

}  // namespace prehend
