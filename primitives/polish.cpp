#include "primitives/polish.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "primitives/fit.h"
#include "sim/base/parallel/parallel.h"

// The greedy splits (split.h) are chosen one after the other, without regard to those that follow.
// Here the set of primitives as a whole is improved by local search with three moves: reassign all
// points to the nearest primitives, drop a primitive, merge two. A move is kept only if it lowers
// the objective, so that the result is never worse than the start.
namespace prehend {
namespace {

using Regions = std::vector<Region>;

// The objective (region.h) of the primitives with used[k], from distance[k][i] of point i to the
// surface of primitive k and phantom[k], the cost of its surface away from the mesh. Computing
// these once makes it cheap to try out subsets.
double total_cost(const std::vector<std::vector<double>>& distance,
                  const std::vector<double>& phantom, const std::vector<bool>& used,
                  const Surface& surface) {
  double cost = 0.0;
  for (std::size_t k = 0; k < phantom.size(); ++k) {
    if (used[k]) cost += phantom[k] + kPieceCost;
  }
  double sum = 0.0;
  // What is not among the points is explained otherwise.
  std::size_t explained = surface.whole - surface.points.size();
  for (std::size_t i = 0; i < surface.points.size(); ++i) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < distance.size(); ++k) {
      if (used[k]) nearest = std::min(nearest, distance[k][i]);
    }
    sum += point_loss(nearest, surface.tolerance);
    if (nearest <= surface.tolerance) ++explained;
  }
  const double count = static_cast<double>(surface.whole);
  const double shortfall = std::max(surface.coverage - static_cast<double>(explained) / count, 0.0);
  return cost + sum / count + kShortfallCost * shortfall;
}

// What total_cost needs of each primitive.
struct Costs {
  std::vector<std::vector<double>> distance;
  std::vector<double> phantom;
};

Costs costs_of(const Regions& regions, const Surface& surface) {
  Costs costs;
  for (const Region& region : regions) {
    costs.distance.push_back(distances(region.fit.primitive, surface.points));
    costs.phantom.push_back(phantom_cost(region.fit.primitive, surface));
  }
  return costs;
}

// One round as in k-means: each point goes to the primitive whose surface is nearest, then each
// primitive is fitted again to its points. Primitives without points disappear.
Regions reassigned(const Regions& regions, const Surface& surface) {
  std::vector<std::vector<SurfacePoint>> points = points_by_nearest(regions, surface);
  std::erase_if(points, [](const std::vector<SurfacePoint>& own) { return own.empty(); });
  return fit_regions(std::move(points), surface);
}

// Removes the primitive without which the objective is lowest, if that lowers it; with `always`,
// also where that raises it. False when nothing was removed.
bool drop_one(Regions& regions, const Surface& surface, bool always) {
  if (regions.size() < 2) return false;
  const Costs costs = costs_of(regions, surface);
  std::vector<bool> used(regions.size(), true);
  double best = always ? std::numeric_limits<double>::infinity()
                       : total_cost(costs.distance, costs.phantom, used, surface);
  std::optional<std::size_t> dropped;
  for (std::size_t k = 0; k < regions.size(); ++k) {
    used[k] = false;
    const double cost = total_cost(costs.distance, costs.phantom, used, surface);
    used[k] = true;
    if (cost < best) {
      best = cost;
      dropped = k;
    }
  }
  if (!dropped) return false;
  regions.erase(regions.begin() + static_cast<std::ptrdiff_t>(*dropped));
  return true;
}

// The points of a region in the place of two.
std::vector<SurfacePoint> united(const Region& a, const Region& b) {
  std::vector<SurfacePoint> points = a.points;
  points.insert(points.end(), b.points.begin(), b.points.end());
  return points;
}

// Merges the pair of regions that one primitive explains at the least extra cost, if that lowers
// the objective. All pairs are compared with quick fits; only the best is fitted thoroughly. False
// when nothing was merged.
bool merge_one(Regions& regions, const Surface& surface) {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0; i < regions.size(); ++i) {
    for (std::size_t j = i + 1; j < regions.size(); ++j) pairs.emplace_back(i, j);
  }
  if (pairs.empty()) return false;
  std::vector<double> rise(pairs.size());
  for_each_in_parallel(pairs.size(), surface.threads, [&](std::size_t k) {
    const Region& a = regions[pairs[k].first];
    const Region& b = regions[pairs[k].second];
    const std::vector<SurfacePoint> points = united(a, b);
    const Fit both =
        quick_fit(thinned(points, kQuickPoints), share_of(points.size(), surface), surface);
    rise[k] = both.cost - a.fit.cost - b.fit.cost;
  });
  const auto least = std::min_element(rise.begin(), rise.end());
  // A merger saves one primitive, so its cost may rise by kPieceCost. The cost of a region counts
  // only the region's own points, though other primitives may explain them too; so this is an
  // estimate, and the objective of the whole set decides below.
  if (!(*least < kPieceCost)) return false;
  const auto [first, second] = pairs[static_cast<std::size_t>(least - rise.begin())];
  Regions merged = regions;
  merged[first] = std::move(fit_regions({united(regions[first], regions[second])}, surface)[0]);
  merged.erase(merged.begin() + static_cast<std::ptrdiff_t>(second));
  if (objective(merged, surface) >= objective(regions, surface)) return false;
  regions = std::move(merged);
  return true;
}

}  // namespace

double objective(const Regions& regions, const Surface& surface) {
  const Costs costs = costs_of(regions, surface);
  return total_cost(costs.distance, costs.phantom, std::vector<bool>(regions.size(), true),
                    surface);
}

Regions polished(Regions regions, const Surface& surface) {
  // Reassigning points can make a primitive superfluous, and dropping or merging changes which
  // primitive is nearest; so the three are repeated, until a round gains too little.
  constexpr int kRounds = 3;
  for (int round = 0; round < kRounds; ++round) {
    const double before = objective(regions, surface);
    Regions candidate = reassigned(regions, surface);
    if (objective(candidate, surface) < before) regions = std::move(candidate);
    while (drop_one(regions, surface, false)) {
    }
    while (merge_one(regions, surface)) {
    }
    constexpr double kWorthwhile = 1e-3;
    if (objective(regions, surface) > before - kWorthwhile) break;
  }
  return regions;
}

Regions reduced(Regions regions, const Surface& surface, std::size_t count) {
  while (regions.size() > count && drop_one(regions, surface, true)) {
  }
  return regions;
}

}  // namespace prehend
