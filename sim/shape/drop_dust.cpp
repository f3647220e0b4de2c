#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "sim/shape/edge_table.h"
#include "sim/shape/repair_steps.h"
#include "sim/shape/shells.h"
#include "sim/shape/weld.h"

namespace prehend {
namespace {

// Shells are dust when their diagonal is shorter than this part of the largest shell's,
constexpr double kDustSize = 0.01;
// and, where they are not closed, than this part.
constexpr double kScrapSize = 0.1;

// Of each shell, whether all its edges have two triangles or more.
std::vector<bool> closed_shells(const TriangleMesh& mesh, const Shells& shells) {
  std::vector<bool> closed(shells.shells.size(), true);
  for_each_edge(edge_uses(mesh), [&](std::span<const EdgeUse> edge) {
    if (edge.size() > 1) return;
    const int shell = shells.of_triangle[static_cast<std::size_t>(edge[0].triangle)];
    closed[static_cast<std::size_t>(shell)] = false;
  });
  return closed;
}

}  // namespace

DroppedDust drop_dust(TriangleMesh& mesh, const RepairOptions& options) {
  const Shells shells = find_shells(mesh);
  double whole = 0.0;
  for (const Shell& shell : shells.shells) whole += shell.area;
  if (shells.shells.size() < 2) return {};
  const std::vector<bool> closed = closed_shells(mesh, shells);
  std::vector<bool> dust(shells.shells.size(), false);
  DroppedDust dropped;
  double dust_area = 0.0;
  for (std::size_t s = 0; s < dust.size(); ++s) {
    const Shell& shell = shells.shells[s];
    const double limit = closed[s] ? kDustSize : kScrapSize;
    dust[s] = shell.box.diagonal() < limit * shells.largest_diagonal;
    if (!dust[s]) continue;
    dust_area += shell.area;
    ++dropped.shells;
  }
  if (dropped.shells == 0 || !(dust_area < options.dust_area * whole)) return {};
  std::size_t left = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!dust[static_cast<std::size_t>(shells.of_triangle[t])]) {
      mesh.triangles[left++] = mesh.triangles[t];
    }
  }
  dropped.triangles = static_cast<int>(mesh.triangles.size() - left);
  mesh.triangles.resize(left);
  drop_unused_vertices(mesh);
  return dropped;
}

}  // namespace prehend
