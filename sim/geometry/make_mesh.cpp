#include "sim/geometry/make_mesh.h"

#include <cstddef>
#include <string>
#include <utility>

#include "sim/base/input_error.h"
#include "sim/geometry/mesh_checks.h"
#include "sim/geometry/weld.h"

namespace prehend {
namespace {

// Beyond this the squares and cubes of lengths leave the range of double.
constexpr double kFarthest = 1e30;  // m

void check_indices(const TriangleMesh& mesh) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const int v : mesh.triangles[t]) {
      if (v >= 0 && static_cast<std::size_t>(v) < mesh.vertices.size()) continue;
      throw InputError("triangles[" + std::to_string(t) + "]: names a vertex that is not there (" +
                       std::to_string(v) + ")");
    }
  }
}

void check_vertices(const TriangleMesh& mesh) {
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    const Vector3& p = mesh.vertices[v];
    if (p.allFinite() && p.cwiseAbs().maxCoeff() <= kFarthest) continue;
    throw InputError("vertices[" + std::to_string(v) + "]: not finite, or farther out than 1e30 m");
  }
}

}  // namespace

TriangleMesh make_mesh(std::vector<Vector3> vertices, std::vector<Triangle> triangles,
                       double weld_fraction) {
  if (!(weld_fraction > 0.0) || !(weld_fraction < 0.01)) {
    throw InputError("weld_fraction: must be above 0 and below 0.01 (" +
                     std::to_string(weld_fraction) + ")");
  }
  TriangleMesh mesh{std::move(vertices), std::move(triangles)};
  check_indices(mesh);
  check_vertices(mesh);
  drop_unused_vertices(mesh);
  const double diagonal = mesh.empty() ? 0.0 : bounds(mesh).diagonal();
  // weld() needs a tolerance above 0; a mesh with all vertices at one point has no area anyway.
  if (diagonal > 0.0) mesh = weld(mesh, weld_fraction * diagonal).mesh;
  if (!(diagonal > 0.0) || mesh.empty()) throw InputError("triangles: none of them has an area");
  orient_outward(mesh);
  return mesh;
}

}  // namespace prehend
