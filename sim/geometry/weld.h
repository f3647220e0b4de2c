// Joins equal vertices and leaves out what bounds no surface.
#pragma once

#include "sim/geometry/triangle_mesh.h"

namespace prehend {

struct WeldedMesh {
  TriangleMesh mesh;           // every vertex used by a triangle
  int vertices_merged = 0;     // vertices replaced by an earlier one
  int degenerate_removed = 0;  // triangles for which is_degenerate holds after welding
  int duplicates_removed = 0;  // triangles with the same three vertices as an earlier one
};

// Three distinct corners are needed, and more area than rounding leaves to a straight line: the
// height over the longest side must exceed 1e-7 of that side (single precision, which mesh files
// use, cannot tell less from zero).
bool is_degenerate(const TriangleMesh& mesh, std::size_t triangle);

// Goes through the vertices in order: one within `tolerance` (> 0) of an earlier one that was kept
// becomes that vertex (of several, the first). Kept vertices and triangles stay in order, positions
// are not averaged; a second weld with the same tolerance changes nothing.
WeldedMesh weld(const TriangleMesh& mesh, double tolerance);

// Leaves out vertices of no triangle; the others and the triangles stay in order.
void drop_unused_vertices(TriangleMesh& mesh);

}  // namespace prehend
