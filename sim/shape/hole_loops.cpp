// The rim is followed from edge to edge: behind each edge the fan of triangles around its end is
// crossed, up to the other edge of that fan that has no triangle beyond.
#include "sim/shape/hole_loops.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "sim/shape/edge_table.h"

namespace prehend {
namespace {

constexpr int kNothingBeyond = -1;
constexpr int kSeveralBeyond = -2;
constexpr int kNowhere = -1;

// Side `k` of a triangle, from its corner k to the next.
struct Side {
  int triangle = 0;
  std::size_t k = 0;
};

class RimWalk {
 public:
  explicit RimWalk(const TriangleMesh& mesh)
      : mesh_(mesh),
        beyond_(mesh.triangles.size(), {kSeveralBeyond, kSeveralBeyond, kSeveralBeyond}),
        done_(mesh.triangles.size(), {false, false, false}),
        place_(mesh.vertices.size(), kNowhere) {
    const std::vector<EdgeUse> uses = edge_uses(mesh);
    for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
      if (edge.size() == 1) beyond(side_of(edge[0])) = kNothingBeyond;
      if (edge.size() != 2) return;
      beyond(side_of(edge[0])) = edge[1].triangle;
      beyond(side_of(edge[1])) = edge[0].triangle;
    });
  }

  std::vector<HoleLoop> loops() {
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (beyond_[t][k] == kNothingBeyond && !done_[t][k]) follow({static_cast<int>(t), k});
      }
    }
    return std::move(found_);
  }

 private:
  const Triangle& corners(int triangle) const {
    return mesh_.triangles[static_cast<std::size_t>(triangle)];
  }
  int& beyond(const Side& side) { return beyond_[static_cast<std::size_t>(side.triangle)][side.k]; }
  bool& done(const Side& side) { return done_[static_cast<std::size_t>(side.triangle)][side.k]; }
  int& place(int vertex) { return place_[static_cast<std::size_t>(vertex)]; }
  int start_of(const Side& side) const { return corners(side.triangle)[side.k]; }

  Side side_of(const EdgeUse& use) const {
    const Triangle& t = corners(use.triangle);
    const int from = use.forward ? use.low : use.high;
    return {use.triangle,
            static_cast<std::size_t>(std::find(t.begin(), t.end(), from) - t.begin())};
  }

  // The side of the rim that ends where `side` starts; none where the fan between them does not
  // lead there.
  std::optional<Side> before(Side side) {
    const int pivot = start_of(side);
    while (true) {
      const Side incoming{side.triangle, (side.k + 2) % 3};
      const int next = beyond(incoming);
      if (next == kNothingBeyond) return incoming;
      if (next == kSeveralBeyond) return std::nullopt;
      const int other = start_of(incoming);
      const Triangle& t = corners(next);
      const std::size_t k =
          static_cast<std::size_t>(std::find(t.begin(), t.end(), pivot) - t.begin());
      if (t[(k + 1) % 3] != other) return std::nullopt;
      side = {next, k};
    }
  }

  // Against the direction of the triangles, which is that of a patch.
  void follow(const Side& first) {
    std::vector<int> chain;
    std::optional<Side> side = first;
    while (side && !done(*side)) {
      done(*side) = true;
      add(start_of(*side), side->triangle, chain);
      side = before(*side);
    }
    const bool whole = side && side->triangle == first.triangle && side->k == first.k;
    for (const int v : chain) place(v) = kNowhere;
    if (whole && chain.size() >= 3) found_.push_back({std::move(chain), first.triangle});
  }

  // A vertex that the chain has already ends a loop of its own.
  void add(int vertex, int triangle, std::vector<int>& chain) {
    if (place(vertex) == kNowhere) {
      place(vertex) = static_cast<int>(chain.size());
      chain.push_back(vertex);
      return;
    }
    const auto start = chain.begin() + place(vertex) + 1;
    std::vector<int> loop(start, chain.end());
    for (const int v : loop) place(v) = kNowhere;
    chain.erase(start, chain.end());
    loop.push_back(vertex);
    if (loop.size() >= 3) found_.push_back({std::move(loop), triangle});
  }

  const TriangleMesh& mesh_;
  std::vector<std::array<int, 3>> beyond_;  // the triangle across each side
  std::vector<std::array<bool, 3>> done_;
  std::vector<int> place_;  // of each vertex in the chain that is followed
  std::vector<HoleLoop> found_;
};

}  // namespace

std::vector<HoleLoop> hole_loops(const TriangleMesh& mesh) { return RimWalk(mesh).loops(); }

}  // namespace prehend
