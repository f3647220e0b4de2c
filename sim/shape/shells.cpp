#include "sim/shape/shells.h"

#include <algorithm>
#include <cstddef>

#include "sim/base/disjoint_sets.h"

namespace prehend {

Shells find_shells(const TriangleMesh& mesh) {
  DisjointSets sets(mesh.vertices.size());
  for (const Triangle& t : mesh.triangles) {
    sets.merge(static_cast<std::size_t>(t[0]), static_cast<std::size_t>(t[1]));
    sets.merge(static_cast<std::size_t>(t[0]), static_cast<std::size_t>(t[2]));
  }
  Shells found;
  found.of_triangle.reserve(mesh.triangles.size());
  std::vector<int> shell_at(mesh.vertices.size(), -1);  // by the representative vertex
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    int& name = shell_at[sets.find(static_cast<std::size_t>(mesh.triangles[t][0]))];
    if (name < 0) {
      name = static_cast<int>(found.shells.size());
      found.shells.emplace_back();
    }
    found.of_triangle.push_back(name);
    Shell& shell = found.shells[static_cast<std::size_t>(name)];
    shell.area += 0.5 * doubled_area_vector(mesh, t).norm();
    for (const int v : mesh.triangles[t]) {
      const Vector3& p = mesh.vertices[static_cast<std::size_t>(v)];
      shell.box.lower = shell.box.lower.cwiseMin(p);
      shell.box.upper = shell.box.upper.cwiseMax(p);
    }
  }
  for (const Shell& shell : found.shells) {
    found.largest_diagonal = std::max(found.largest_diagonal, shell.box.diagonal());
  }
  return found;
}

}  // namespace prehend
