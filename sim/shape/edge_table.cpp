#include "sim/shape/edge_table.h"

#include <algorithm>
#include <tuple>

// The two ends of an edge are stored in ascending order, so that both of its triangles name it in
// the same way. Sorting then brings all uses of an edge together. The triangle is the last key: the
// order is unique, whatever the sorting algorithm.
namespace prehend {

std::vector<EdgeUse> edge_uses(const TriangleMesh& mesh) {
  std::vector<EdgeUse> uses;
  uses.reserve(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& v = mesh.triangles[t];
    // A triangle with a repeated vertex would use an edge twice, or one from a vertex to itself.
    if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0]) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const int from = v[k];
      const int to = v[(k + 1) % 3];
      uses.push_back({std::min(from, to), std::max(from, to), static_cast<int>(t), from < to});
    }
  }
  std::sort(uses.begin(), uses.end(), [](const EdgeUse& a, const EdgeUse& b) {
    return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
  });
  return uses;
}

int net_direction(std::span<const EdgeUse> edge) {
  int net = 0;
  for (const EdgeUse& use : edge) net += use.forward ? 1 : -1;
  return net;
}

}  // namespace prehend
