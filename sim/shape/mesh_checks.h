// Diagnosis and repair of the orientation of a mesh: whether it is closed, manifold and
// consistently wound, and which way it faces.
#pragma once

#include <string>

#include "sim/shape/triangle_mesh.h"

namespace prehend {

// Counts of the parts of a mesh and of the defects that keep it from bounding a solid.
struct MeshChecks {
  int vertices = 0;
  int triangles = 0;
  int nonfinite_vertices = 0;    // with a coordinate that is infinite or not a number
  int degenerate_triangles = 0;  // without area (is_degenerate in weld.h); left out below
  int components = 0;            // sets of triangles connected by shared vertices
  int boundary_edges = 0;        // edges of exactly one triangle
  int nonmanifold_edges = 0;     // edges of three or more triangles
  int misoriented_edges = 0;     // edges of two triangles that are wound against each other
  bool inward = false;           // solid, but the signed volume is negative

  // Every edge belongs to exactly two triangles.
  bool closed() const { return triangles > 0 && boundary_edges == 0 && nonmanifold_edges == 0; }
  // Closed, finite and consistently wound, so that the signed volume is that of a solid.
  bool solid() const { return closed() && misoriented_edges == 0 && nonfinite_vertices == 0; }
};

// Throws InputError that names the first triangle with a vertex index out of range: as
// "triangles[3]", or inside `name`, what the caller calls the mesh.
void require_valid_indices(const TriangleMesh& mesh, const std::string& name = {});

// Counts the parts and defects of `mesh`. Throws InputError when a vertex index is out of range.
MeshChecks check_mesh(const TriangleMesh& mesh);

// Sum of the signed volumes of the tetrahedra between the centre of the bounding box and each
// triangle [m^3]: the enclosed volume of a solid mesh, negative when its triangles face inward.
double signed_volume(const TriangleMesh& mesh);

// Turns triangles so that the surface faces outward. Returns the number of triangles turned.
//
// 1. Triangles joined over edges of exactly two triangles form a sheet; each sheet is made to agree
//    with itself (a one-sided sheet, like a Moebius strip, as far as it goes).
// 2. Each sheet is turned so that its signed volume about its own centroid is positive: outward for
//    a closed sheet, most of its area facing away from its centroid for an open one. A sheet
//    without such a volume (flat) keeps the winding of its first triangle.
// 3. Except cavities: a closed sheet that the file wound consistently, opposite to the closed sheet
//    around it (the smallest one that contains it and is no cavity itself), bounds a hollow of that
//    solid and is turned inward. With the same winding it is a part inside another part and is
//    turned outward.
int orient_outward(TriangleMesh& mesh);

// Step 1 of orient_outward alone: turns triangles so that each sheet agrees with itself, the fewer
// ones of each sheet, as many as it takes. Returns the number of triangles turned.
int make_consistent(TriangleMesh& mesh);

}  // namespace prehend
