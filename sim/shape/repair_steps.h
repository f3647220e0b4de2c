// The steps of repair_mesh (mesh_repair.h), each on a welded mesh.
#pragma once

#include "sim/base/run_context.h"
#include "sim/shape/mesh_repair.h"
#include "sim/shape/triangle_mesh.h"

namespace prehend {

// Shells (triangles connected by shared vertices) that were dropped, and their triangles.
struct DroppedDust {
  int shells = 0;
  int triangles = 0;
};

// Drops the shells that are dust, and the vertices that only they use.
DroppedDust drop_dust(TriangleMesh& mesh, const RepairOptions& options);

// Divides triangles at boundary vertices that lie on one of their boundary edges, where a part of
// the divided edge then meets another boundary edge, and drops slivers that are there twice then.
// The mesh stays as it is where all this would not leave fewer boundary edges, or would make more
// edges of three triangles. `within` [m]. Returns the number of vertices.
// Takes time in proportion to the pairs of boundary edge and boundary vertex that overlap along the
// longest axis; where these are more than a hundred per boundary edge, it leaves the mesh as it is.
int divide_at_cracks(TriangleMesh& mesh, double within, const RunContext& context);

// What close_holes did.
struct ClosedHoles {
  int closed = 0;
  int left = 0;
  double area = 0.0;  // of the patches [m^2]
};

// Closes the holes within the options. The mesh is wound consistently where it can be.
ClosedHoles close_holes(TriangleMesh& mesh, const RepairOptions& options,
                        const RunContext& context);

}  // namespace prehend
