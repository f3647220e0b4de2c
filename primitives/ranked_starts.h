// Chooses the few of many starting directions from which a fit is tried. A fit by Gauss-Newton
// finds the nearest local minimum only, and a fit from every direction would take too long.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "primitives/fit.h"
#include "primitives/point_columns.h"

namespace prehend {

// make(direction, points, tail) gives a starting shape, residuals(shape, points) the distances of
// the points from it. For each of the starting tails, the best directions on a small sample of the
// points, made again from all points.
template <class Direction, class Make, class Residuals>
auto ranked_starts(const std::vector<Direction>& directions, const PointColumns& points,
                   const FitOptions& options, const Make& make, const Residuals& residuals) {
  constexpr Eigen::Index kRankingPoints = 96;
  const std::size_t kept = std::min<std::size_t>(options.thorough ? 2 : 1, directions.size());
  const PointColumns few = thinned(points, kRankingPoints);
  std::vector<decltype(make(directions.front(), points, 0.0))> starts;
  for (const double tail : starting_tails(options)) {
    std::vector<std::pair<double, std::size_t>> ranked;
    for (std::size_t i = 0; i < directions.size(); ++i) {
      const Eigen::ArrayXd far = residuals(make(directions[i], few, tail), few);
      ranked.emplace_back(far.abs().min(2.0 * options.outlier).sum(), i);
    }
    std::sort(ranked.begin(), ranked.end());
    for (std::size_t k = 0; k < kept; ++k) {
      starts.push_back(make(directions[ranked[k].second], points, tail));
    }
  }
  return starts;
}

}  // namespace prehend
