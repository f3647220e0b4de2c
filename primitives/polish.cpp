#include "primitives/polish.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "primitives/fit.h"

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
  std::size_t explained = 0;
  for (std::size_t i = 0; i < surface.points.size(); ++i) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < distance.size(); ++k) {
      if (used[k]) nearest = std::min(nearest, distance[k][i]);
    }
    sum += point_loss(nearest, surface.tolerance);
    if (nearest <= surface.tolerance) ++explained;
  }
  const double count = static_cast<double>(surface.points.size());
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
    costs.distance.push_back(distances(region.primitive, surface));
    costs.phantom.push_back(phantom_cost(region.primitive, surface));
  }
  return costs;
}

// One round as in k-means: each point goes to the primitive whose surface is nearest, then each
// primitive is fitted again to its points. Primitives without points disappear.
Regions reassigned(const Regions& regions, const Surface& surface) {
  const Costs costs = costs_of(regions, surface);
  std::vector<std::vector<SurfacePoint>> points(regions.size());
  for (std::size_t i = 0; i < surface.points.size(); ++i) {
    std::size_t nearest = 0;
    for (std::size_t k = 1; k < regions.size(); ++k) {
      if (costs.distance[k][i] < costs.distance[nearest][i]) nearest = k;
    }
    points[nearest].push_back(surface.points[i]);
  }
  Regions result;
  for (std::vector<SurfacePoint>& own : points) {
    if (!own.empty()) result.push_back(fit_region(std::move(own), surface, Effort::thorough));
  }
  return result;
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

// One region in the place of two.
Region united(const Region& a, const Region& b, const Surface& surface, Effort effort) {
  std::vector<SurfacePoint> points = a.points;
  points.insert(points.end(), b.points.begin(), b.points.end());
  return fit_region(std::move(points), surface, effort);
}

// Merges the pair of regions that one primitive explains at the least extra cost, if that lowers
// the objective. All pairs are compared with quick fits; only the best is fitted thoroughly. False
// when nothing was merged.
bool merge_one(Regions& regions, const Surface& surface) {
  const double before = objective(regions, surface);
  // A merger saves one primitive, so its cost may rise by kPieceCost. The cost of a region counts
  // only the region's own points, though other primitives may explain them too; so this is an
  // estimate, and the objective of the whole set decides below.
  double best_rise = kPieceCost;
  std::optional<std::pair<std::size_t, std::size_t>> pair;
  for (std::size_t i = 0; i < regions.size(); ++i) {
    for (std::size_t j = i + 1; j < regions.size(); ++j) {
      const Region both = united(regions[i], regions[j], surface, Effort::quick);
      const double rise = both.cost - regions[i].cost - regions[j].cost;
      if (rise < best_rise) {
        best_rise = rise;
        pair = {i, j};
      }
    }
  }
  if (!pair) return false;
  Regions merged = regions;
  merged[pair->first] =
      united(regions[pair->first], regions[pair->second], surface, Effort::thorough);
  merged.erase(merged.begin() + static_cast<std::ptrdiff_t>(pair->second));
  if (objective(merged, surface) >= before) return false;
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
