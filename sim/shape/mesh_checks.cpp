#include "sim/shape/mesh_checks.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "sim/base/disjoint_sets.h"
#include "sim/base/input_error.h"
#include "sim/shape/edge_table.h"
#include "sim/shape/weld.h"

namespace prehend {
namespace {

// Number of sets of triangles connected by shared vertices; vertices of no triangle do not count.
int count_components(const TriangleMesh& mesh) {
  DisjointSets sets(mesh.vertices.size());
  for (const Triangle& t : mesh.triangles) {
    sets.merge(static_cast<std::size_t>(t[0]), static_cast<std::size_t>(t[1]));
    sets.merge(static_cast<std::size_t>(t[0]), static_cast<std::size_t>(t[2]));
  }
  std::vector<bool> seen(mesh.vertices.size(), false);
  int count = 0;
  for (const Triangle& t : mesh.triangles) {
    const std::size_t root = sets.find(static_cast<std::size_t>(t[0]));
    if (!seen[root]) ++count;
    seen[root] = true;
  }
  return count;
}

}  // namespace

void require_valid_indices(const TriangleMesh& mesh, const std::string& name) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const int v : mesh.triangles[t]) {
      if (v >= 0 && static_cast<std::size_t>(v) < mesh.vertices.size()) continue;
      const InputError error({.field = "triangles[" + std::to_string(t) + "]",
                              .problem = "names a vertex that is not there",
                              .value = std::to_string(v)});
      throw error.under(name);
    }
  }
}

MeshChecks check_mesh(const TriangleMesh& mesh) {
  require_valid_indices(mesh);
  MeshChecks checks;
  checks.vertices = static_cast<int>(mesh.vertices.size());
  checks.triangles = static_cast<int>(mesh.triangles.size());
  for (const Vector3& p : mesh.vertices) checks.nonfinite_vertices += p.allFinite() ? 0 : 1;

  // Degenerate triangles would hide defects: they add uses to edges without closing any surface.
  TriangleMesh sound{mesh.vertices, {}};
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (is_degenerate(mesh, t)) {
      ++checks.degenerate_triangles;
    } else {
      sound.triangles.push_back(mesh.triangles[t]);
    }
  }
  checks.components = count_components(sound);
  // On a closed surface every edge belongs to two triangles. Consistently wound, they traverse it
  // in opposite directions, and their net direction is 0.
  for_each_edge(edge_uses(sound), [&](std::span<const EdgeUse> edge) {
    if (edge.size() == 1) ++checks.boundary_edges;
    if (edge.size() > 2) ++checks.nonmanifold_edges;
    if (edge.size() == 2 && net_direction(edge) != 0) ++checks.misoriented_edges;
  });
  checks.inward = checks.solid() && signed_volume(sound) < 0.0;
  return checks;
}

// By the divergence theorem: six times the volume of the tetrahedron between a triangle and a fixed
// point is the product of the doubled area vector and the vector from the point to a corner.
double signed_volume(const TriangleMesh& mesh) {
  if (mesh.empty()) return 0.0;
  // About the centre of the bounds: far from the origin large terms would cancel.
  const Vector3 center = bounds(mesh).center();
  double sextuple = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vector3& a = mesh.vertices[static_cast<std::size_t>(mesh.triangles[t][0])];
    sextuple += (a - center).dot(doubled_area_vector(mesh, t));
  }
  return sextuple / 6.0;
}

}  // namespace prehend
