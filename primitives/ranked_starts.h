// Chooses the few of many starting directions from which a fit is tried. A fit by Gauss-Newton
// finds the nearest local minimum only, and a fit from every direction would take too long.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "primitives/fit.h"

namespace prehend {

// make(direction, points, tail) gives a starting shape, residual(shape, p_O) a point's distance
// from it. For each of the starting tails, the best directions on a small sample of the points,
// made again from all points.
template <class Direction, class Make, class Residual>
auto ranked_starts(const std::vector<Direction>& directions, std::span<const SurfacePoint> points,
                   const FitOptions& options, const Make& make, const Residual& residual) {
  constexpr std::size_t kQuickPoints = 96;
  const std::size_t kept = std::min<std::size_t>(options.thorough ? 2 : 1, directions.size());
  const std::vector<SurfacePoint> few = thinned(points, kQuickPoints);
  std::vector<decltype(make(directions.front(), points, 0.0))> starts;
  for (const double tail : starting_tails(options)) {
    std::vector<std::pair<double, std::size_t>> ranked;
    for (std::size_t i = 0; i < directions.size(); ++i) {
      const auto shape = make(directions[i], few, tail);
      double sum = 0.0;
      for (const SurfacePoint& s : few) {
        sum += std::min(std::abs(residual(shape, s.p_O)), 2.0 * options.outlier);
      }
      ranked.emplace_back(sum, i);
    }
    std::sort(ranked.begin(), ranked.end());
    for (std::size_t k = 0; k < kept; ++k) {
      starts.push_back(make(directions[ranked[k].second], points, tail));
    }
  }
  return starts;
}

}  // namespace prehend
