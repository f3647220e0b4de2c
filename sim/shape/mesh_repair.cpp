#include "sim/shape/mesh_repair.h"

#include <vector>

#include "sim/base/formatted.h"
#include "sim/base/input_error.h"
#include "sim/base/joined.h"
#include "sim/shape/repair_steps.h"
#include "sim/shape/shells.h"

namespace prehend {
namespace {

// "1 hole", "3 holes".
std::string counted(int count, const char* one, const char* several) {
  return std::to_string(count) + " " + (count == 1 ? one : several);
}

// Whether there was dust.
bool drop(MeshRepair& repair, const RepairOptions& options) {
  const DroppedDust dust = drop_dust(repair.mesh, options);
  repair.dust_shells += dust.shells;
  repair.dust_triangles += dust.triangles;
  return dust.shells > 0;
}

// One pass closes what can be closed as the mesh is. What a pass has changed may let the next one
// close more: an edge with vertices on it, beside another such edge of the same triangle. Every
// pass that changes something leaves fewer boundary edges, up to the few that dividing adds; the
// limit is never reached and only guards against endless passes.
void close(MeshRepair& repair, const RepairOptions& options, const RunContext& context) {
  constexpr int kMostPasses = 100;
  for (int pass = 0; pass < kMostPasses; ++pass) {
    context.cancellation.check();
    const double size = find_shells(repair.mesh).largest_diagonal;
    const int cracks = divide_at_cracks(repair.mesh, options.crack * size, context);
    repair.cracks += cracks;
    // Divided edges first: the slits that they close must not be taken for holes.
    if (cracks > 0) {
      repair.turned += make_consistent(repair.mesh);
      continue;
    }
    const ClosedHoles holes = close_holes(repair.mesh, options, context);
    repair.holes += holes.closed;
    repair.holes_left = holes.left;
    repair.patch_area += holes.area;
    if (holes.closed == 0) return;
  }
}

}  // namespace

MeshRepair repair_mesh(const TriangleMesh& mesh, const RepairOptions& options,
                       const RunContext& context) {
  MeshRepair repair;
  repair.before = check_mesh(mesh);
  require(repair.before.nonfinite_vertices == 0,
          {.field = "mesh", .problem = "has vertices that are not finite"});
  repair.mesh = mesh;
  const bool solid = repair.before.solid() && repair.before.degenerate_triangles == 0;
  if (!solid) repair.turned = make_consistent(repair.mesh);
  drop(repair, options);
  // Patches enlarge the surface, of which dust is a smaller part then.
  do {
    if (!solid) close(repair, options, context);
  } while (drop(repair, options));
  context.cancellation.check();
  repair.faced = orient_outward(repair.mesh);
  repair.after = repair.changed() || repair.faced > 0 ? check_mesh(repair.mesh) : repair.before;
  return repair;
}

std::string repair_text(const MeshRepair& repair) {
  std::string words;
  const auto add = [&](int count, const std::string& text) {
    if (count > 0) add_part(words, text);
  };
  add(repair.dust_shells, counted(repair.dust_shells, "speck of dust", "specks of dust") +
                              " dropped (" +
                              counted(repair.dust_triangles, "triangle", "triangles") + ")");
  add(repair.cracks, "cracks closed at " + counted(repair.cracks, "vertex", "vertices"));
  add(repair.holes, counted(repair.holes, "hole", "holes") + " closed" +
                        formatted(" (%.3g %% of the surface)",
                                  100.0 * repair.patch_area / surface_area(repair.mesh)));
  add(repair.turned,
      counted(repair.turned, "triangle", "triangles") + " turned that disagreed with those around");
  return words;
}

std::string missing_text(const MeshChecks& checks) {
  std::string words;
  const auto add = [&](int count, const char* one, const char* several) {
    if (count > 0) add_part(words, counted(count, one, several));
  };
  add(checks.boundary_edges, "boundary edge (holes)", "boundary edges (holes)");
  add(checks.nonmanifold_edges, "edge of three or more triangles",
      "edges of three or more triangles");
  add(checks.misoriented_edges, "edge whose triangles disagree on outside",
      "edges whose triangles disagree on outside");
  return words;
}

std::string trust_text(const MeshChecks& checks, MassSource source) {
  switch (source) {
    case MassSource::signed_volume:
      return checks.solid() ? "volume, centre of mass and inside are those of the solid"
                            : "volume and centre of mass are exact, parts that overlap count twice";
    case MassSource::closed_holes:
      return "volume and centre of mass are estimates with the holes closed, inside is uncertain "
             "near them";
    case MassSource::convex_hull:
      return "volume, centre of mass and the scale of torques are estimates from the convex hull, "
             "inside is uncertain";
    case MassSource::surface:
      break;
  }
  return "a sheet without thickness: the centre of mass is that of the surface, nothing is inside";
}

}  // namespace prehend
