// Merging of coincident vertices and removal of degenerate and duplicate triangles.
#pragma once

#include "sim/shape/triangle_mesh.h"

namespace prehend {

// A mesh after welding, and what was merged and removed.
struct WeldedMesh {
  TriangleMesh mesh;           // every vertex used by a triangle
  int vertices_merged = 0;     // vertices replaced by an earlier one
  int degenerate_removed = 0;  // triangles for which is_degenerate holds after welding
  int duplicates_removed = 0;  // triangles with the same three vertices as an earlier one
};

// Whether a triangle has a repeated vertex or no area: its height over its longest side is at most
// 1e-7 of that side. Mesh files store coordinates in single precision, whose rounding makes
// collinear points deviate about that much.
bool is_degenerate(const TriangleMesh& mesh, std::size_t triangle);

// Merges vertices and removes degenerate and duplicate triangles. Vertices are visited in order;
// each one within `tolerance` (> 0) [m] of earlier kept vertices is replaced by the first of those.
// Kept vertices and triangles stay in order, and positions are not averaged. A second weld with the
// same tolerance changes nothing.
WeldedMesh weld(const TriangleMesh& mesh, double tolerance);

// As weld, with a tolerance of `fraction` (> 0, < 0.01) of the mesh's bounding-box diagonal. Throws
// InputError for another fraction, for a mesh whose vertices are all at one point, and when no
// triangle with an area is left.
WeldedMesh weld_to_scale(const TriangleMesh& mesh, double fraction);

// Removes vertices that no triangle uses; the others and the triangles stay in order.
void drop_unused_vertices(TriangleMesh& mesh);

}  // namespace prehend
