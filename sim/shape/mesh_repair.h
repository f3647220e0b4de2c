// What keeps a surface from bounding a solid, and the repair of what can be repaired without
// guessing: cracks, small and flat holes, wrong winding, dust.
#pragma once

#include <string>

#include "sim/base/run_context.h"
#include "sim/base/settings.h"
#include "sim/shape/mass_properties.h"
#include "sim/shape/mesh_checks.h"
#include "sim/shape/triangle_mesh.h"

namespace prehend {

// Where repair ends. Lengths are fractions of the diagonal of the bounds of the largest shell
// (triangles connected by shared vertices), areas of the area of the shell.
struct RepairOptions {
  static constexpr AboutSettings kAbout{"RepairOptions", "How far a surface is repaired."};
  double dust_area = 0.01;
  double crack = 1e-5;
  double hole_area = 0.25;
};

template <SettingsOf<RepairOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [dust_area, crack, hole_area] = options;
  visit("dust_area", dust_area, kRatio, "",
        "Small shells (drop_dust.cpp) are dropped when all of them together have less than this "
        "part of the surface.");
  visit("crack", crack, kRatio, "",
        "A boundary vertex within this distance of a boundary edge lies on it (a T-junction): the "
        "triangle of the edge is divided there.");
  visit("hole_area", hole_area, kRatio, "",
        "Largest area of a hole that is closed, if it is flat or small (close_holes.cpp).");
}

// A surface that faces outward as far as it tells, and what was done to it.
struct MeshRepair {
  TriangleMesh mesh;
  MeshChecks before;
  MeshChecks after;
  int dust_shells = 0;      // shells dropped
  int dust_triangles = 0;   // and their triangles
  int turned = 0;           // triangles that disagreed with most of their sheet, turned
  int faced = 0;            // triangles of sheets that faced the wrong way as a whole, turned
  int cracks = 0;           // vertices at which triangles were divided
  int holes = 0;            // closed
  int holes_left = 0;       // rims that are still open
  double patch_area = 0.0;  // of the closed holes [m^2]

  // Whether triangles were added, divided, dropped or turned against their neighbours.
  bool changed() const { return dust_shells + turned + cracks + holes > 0; }
};

// Repairs a welded mesh (weld.h) in this order: dust is dropped; triangles that disagree with most
// of their sheet are turned; cracks and holes are closed; sheets are turned outward, cavities
// inward (orient_outward).
//
// - A mesh of closed, consistently wound shells without dust comes back with the bytes that
//   orient_outward gives.
// - Left open: holes beyond the options; holes whose patch would use an edge of the mesh again or
//   have a triangle without area; of large holes (not small ones) two in one shell, which may be
//   the ends of a pipe, and two of similar size of which one lies within the other, which may be
//   the rim of a vessel; rims that meet edges of three or more triangles.
// - Triangles are added behind those that are there; patches use the vertices of the rim, so that
//   a flat hole in a flat face is closed exactly.
// - A repaired mesh is not repaired any further: the second call returns the same bytes.
//
// O(n log n) for n triangles. Throws InputError for an index out of range or a vertex that is not
// finite, Cancelled.
MeshRepair repair_mesh(const TriangleMesh& mesh, const RepairOptions& options = {},
                       const RunContext& context = {});

// What was repaired, for people: "1 hole closed (16.7 % of the surface)"; empty when nothing was.
std::string repair_text(const MeshRepair& repair);

// What a mesh lacks to bound a solid: "4 boundary edges (holes)"; empty for a solid.
std::string missing_text(const MeshChecks& checks);

// Which numbers of an object with this surface can be relied on: volume and centre of mass, which
// also scales torques, and what is inside.
std::string trust_text(const MeshChecks& checks, MassSource source);

}  // namespace prehend
