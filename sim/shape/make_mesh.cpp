#include "sim/shape/make_mesh.h"

#include <cstddef>
#include <string>
#include <utility>

#include "sim/base/input_error.h"
#include "sim/base/range.h"
#include "sim/shape/mesh_checks.h"
#include "sim/shape/weld.h"

namespace prehend {
namespace {

void check_vertices(const TriangleMesh& mesh) {
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    const Vector3& p = mesh.vertices[v];
    if (p.allFinite() && p.cwiseAbs().maxCoeff() <= kFarthest) continue;
    throw InputError({.field = "vertices[" + std::to_string(v) + "]",
                      .problem = "not finite, or farther out than 1e6 m"});
  }
}

}  // namespace

// Indices are checked first because everything else uses them, and vertices before the removal of
// unused ones, so that errors name their place in the given lists. Unused vertices must not enlarge
// the bounding box to which the weld tolerance is relative. Orientation comes last: only welded
// triangles share vertices, and with them the edges over which they are made to agree.
TriangleMesh make_mesh(std::vector<Vector3> vertices, std::vector<Triangle> triangles,
                       double weld_fraction) {
  TriangleMesh mesh{std::move(vertices), std::move(triangles)};
  require_valid_indices(mesh);
  check_vertices(mesh);
  drop_unused_vertices(mesh);
  if (mesh.empty()) throw InputError({.field = "triangles", .problem = "none, and so no area"});
  mesh = weld_to_scale(mesh, weld_fraction).mesh;
  orient_outward(mesh);
  return mesh;
}

}  // namespace prehend
