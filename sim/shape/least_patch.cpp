// Dynamic programming over stretches of the rim: the best patch of the stretch from i to k, closed
// by the chord between its ends, is a triangle i, j, k and the best patches on both sides of it.
#include "sim/shape/least_patch.h"

#include <cstddef>
#include <limits>
#include <utility>

#include "sim/shape/weld.h"

namespace prehend {
namespace {

// Only limits time: one loop takes a few milliseconds.
constexpr std::size_t kLongestRim = 150;
constexpr double kImpossible = std::numeric_limits<double>::infinity();

class LeastPatch {
 public:
  LeastPatch(const TriangleMesh& mesh, const std::vector<int>& rim,
             const std::function<bool(int, int)>& free)
      : rim_(rim), free_(free), n_(rim.size()), best_(n_ * n_), apex_(n_ * n_) {
    // One triangle at a time stands in it, for is_degenerate.
    for (const int v : rim) scratch_.vertices.push_back(mesh.vertices[static_cast<std::size_t>(v)]);
    scratch_.triangles.resize(1);
  }

  std::vector<Triangle> run() {
    for (std::size_t span = 2; span < n_; ++span) {
      for (std::size_t i = 0; i + span < n_; ++i) solve(i, i + span);
    }
    if (best_[n_ - 1] == kImpossible) return {};
    std::vector<Triangle> triangles;
    std::vector<std::pair<std::size_t, std::size_t>> open{{0, n_ - 1}};
    while (!open.empty()) {
      const auto [i, k] = open.back();
      open.pop_back();
      if (k - i < 2) continue;
      const std::size_t j = apex_[i * n_ + k];
      triangles.push_back({static_cast<int>(i), static_cast<int>(j), static_cast<int>(k)});
      open.emplace_back(i, j);
      open.emplace_back(j, k);
    }
    return triangles;
  }

 private:
  void solve(std::size_t i, std::size_t k) {
    double& best = best_[i * n_ + k];
    best = kImpossible;
    const bool chord = i != 0 || k != n_ - 1;
    if (chord && !free_(rim_[i], rim_[k])) return;
    for (std::size_t j = i + 1; j < k; ++j) {
      const double beside = best_[i * n_ + j] + best_[j * n_ + k];
      if (!(beside < best)) continue;
      scratch_.triangles[0] = {static_cast<int>(i), static_cast<int>(j), static_cast<int>(k)};
      if (is_degenerate(scratch_, 0)) continue;
      const double area = beside + 0.5 * doubled_area_vector(scratch_, 0).norm();
      if (!(area < best)) continue;
      best = area;
      apex_[i * n_ + k] = j;
    }
  }

  const std::vector<int>& rim_;
  const std::function<bool(int, int)>& free_;
  std::size_t n_;
  std::vector<double> best_;       // of the stretch from i to k, at i * n + k
  std::vector<std::size_t> apex_;  // of its triangle at the chord
  TriangleMesh scratch_;
};

}  // namespace

std::vector<Triangle> least_patch(const TriangleMesh& mesh, const std::vector<int>& rim,
                                  const std::function<bool(int, int)>& free) {
  if (rim.size() < 3 || rim.size() > kLongestRim) return {};
  return LeastPatch(mesh, rim, free).run();
}

}  // namespace prehend
