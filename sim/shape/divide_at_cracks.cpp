// Boundary edges are compared with the boundary vertices within their stretch of the longest axis.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "sim/shape/edge_table.h"
#include "sim/shape/mesh_checks.h"
#include "sim/shape/repair_steps.h"
#include "sim/shape/weld.h"

namespace prehend {
namespace {

// A vertex on an edge, `along` it from 0 to 1.
struct OnEdge {
  double along = 0.0;
  int vertex = 0;
};

class CrackDivider {
 public:
  CrackDivider(TriangleMesh& mesh, double within, const RunContext& context)
      : mesh_(mesh), within_(within), context_(context), uses_(edge_uses(mesh)) {}

  int run() {
    gather();
    if (rims_.empty() || too_many()) return 0;
    int divided = 0;
    std::vector<bool> touched(mesh_.triangles.size(), false);
    for (const EdgeUse& rim : rims_) {
      context_.cancellation.check();
      // A triangle that was divided already is looked at in the next pass.
      if (touched[static_cast<std::size_t>(rim.triangle)]) continue;
      std::vector<OnEdge> on = vertices_on(rim);
      if (on.empty() || !joins(rim, on)) continue;
      divide(rim, on);
      touched[static_cast<std::size_t>(rim.triangle)] = true;
      divided += static_cast<int>(on.size());
    }
    // A sliver that lies on the divided edge is now there twice, once from each side. Nothing is
    // merged at this distance.
    if (divided > 0) mesh_ = weld_to_scale(mesh_, 1e-12).mesh;
    return divided;
  }

 private:
  const Vector3& at(int vertex) const { return mesh_.vertices[static_cast<std::size_t>(vertex)]; }
  double height(int vertex) const { return at(vertex)[axis_]; }

  // Boundary edges, and boundary vertices in the order of their heights along the longest axis.
  void gather() {
    bounds(mesh_).size().maxCoeff(&axis_);
    for_each_edge(uses_, [&](std::span<const EdgeUse> edge) {
      if (edge.size() != 1) return;
      rims_.push_back(edge[0]);
      vertices_.push_back(edge[0].low);
      vertices_.push_back(edge[0].high);
    });
    std::sort(vertices_.begin(), vertices_.end());
    vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
    std::stable_sort(vertices_.begin(), vertices_.end(),
                     [&](int a, int b) { return height(a) < height(b); });
  }

  std::span<const int> beside(const EdgeUse& rim) const {
    const auto [low, high] = std::minmax({height(rim.low), height(rim.high)});
    const auto first =
        std::lower_bound(vertices_.begin(), vertices_.end(), low - within_,
                         [&](int vertex, double limit) { return height(vertex) < limit; });
    const auto last =
        std::upper_bound(first, vertices_.end(), high + within_,
                         [&](double limit, int vertex) { return limit < height(vertex); });
    return {first, last};
  }

  // Only limits time: rims of a soup of long triangles would be compared each with each.
  bool too_many() const {
    constexpr std::size_t kPairsPerEdge = 100;
    constexpr std::size_t kFewPairs = 10'000'000;
    std::size_t pairs = 0;
    for (const EdgeUse& rim : rims_) pairs += beside(rim).size();
    return pairs > std::max(kFewPairs, kPairsPerEdge * rims_.size());
  }

  std::vector<OnEdge> vertices_on(const EdgeUse& rim) const {
    const Vector3& start = at(rim.low);
    const Vector3 edge = at(rim.high) - start;
    const double squared = edge.squaredNorm();
    std::vector<OnEdge> on;
    for (const int v : beside(rim)) {
      if (v == rim.low || v == rim.high) continue;
      const double along = (at(v) - start).dot(edge) / squared;
      if (!(along > 0.0 && along < 1.0)) continue;
      if ((at(v) - start - along * edge).norm() > within_) continue;
      on.push_back({along, v});
    }
    std::sort(on.begin(), on.end(), [](const OnEdge& a, const OnEdge& b) {
      return std::pair(a.along, a.vertex) < std::pair(b.along, b.vertex);
    });
    return on;
  }

  std::size_t count_uses(int a, int b) const {
    const auto [low, high] = std::minmax({a, b});
    const auto before = [](const EdgeUse& use, const std::pair<int, int>& ends) {
      return std::pair(use.low, use.high) < ends;
    };
    const auto first = std::lower_bound(uses_.begin(), uses_.end(), std::pair(low, high), before);
    std::size_t count = 0;
    for (auto use = first; use != uses_.end() && use->low == low && use->high == high; ++use) {
      ++count;
    }
    return count;
  }

  // Whether a part of the divided edge meets another boundary edge, and none one that has two
  // triangles already. The triangle's own corner opposite the edge cannot divide it.
  bool joins(const EdgeUse& rim, const std::vector<OnEdge>& on) const {
    const Triangle& t = mesh_.triangles[static_cast<std::size_t>(rim.triangle)];
    bool meets = false;
    int from = rim.low;
    for (std::size_t i = 0; i <= on.size(); ++i) {
      const int to = i < on.size() ? on[i].vertex : rim.high;
      if (std::find(t.begin(), t.end(), to) != t.end() && to != rim.high) return false;
      const std::size_t count = count_uses(from, to);
      if (count > 1) return false;
      meets = meets || count == 1;
      from = to;
    }
    return meets;
  }

  void divide(const EdgeUse& rim, std::vector<OnEdge>& on) {
    const Triangle t = mesh_.triangles[static_cast<std::size_t>(rim.triangle)];
    int from = rim.forward ? rim.low : rim.high;
    const int end = rim.forward ? rim.high : rim.low;
    if (!rim.forward) std::reverse(on.begin(), on.end());
    int apex = t[0];
    for (const int v : t) apex = v != rim.low && v != rim.high ? v : apex;
    for (std::size_t i = 0; i <= on.size(); ++i) {
      const int to = i < on.size() ? on[i].vertex : end;
      if (i == 0) mesh_.triangles[static_cast<std::size_t>(rim.triangle)] = {from, to, apex};
      if (i > 0) mesh_.triangles.push_back({from, to, apex});
      from = to;
    }
  }

  TriangleMesh& mesh_;
  double within_;
  const RunContext& context_;
  std::vector<EdgeUse> uses_;
  std::vector<EdgeUse> rims_;
  std::vector<int> vertices_;
  Eigen::Index axis_ = 0;
};

}  // namespace

int divide_at_cracks(TriangleMesh& mesh, double within, const RunContext& context) {
  TriangleMesh divided = mesh;
  const int vertices = CrackDivider(divided, within, context).run();
  if (vertices == 0) return 0;
  const MeshChecks before = check_mesh(mesh);
  const MeshChecks after = check_mesh(divided);
  if (after.boundary_edges >= before.boundary_edges ||
      after.nonmanifold_edges > before.nonmanifold_edges) {
    return 0;
  }
  mesh = std::move(divided);
  return vertices;
}

}  // namespace prehend
