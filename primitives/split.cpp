#include "primitives/split.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "primitives/fit.h"
#include "sim/base/parallel/parallel.h"

// A split is found by trying: every candidate divides the points in two, and a quick fit to each
// part tells what the two primitives would cost. The candidates are planes in a few directions at a
// few positions, and the separation of points near the region's primitive from all others.
//
// Candidates are tried in parallel. One is given up as soon as its first fit alone costs more than
// the cheapest candidate that is known by then. Which ones are depends on the threads, but the
// cheapest of all is never given up, so that the result does not.
namespace prehend {
namespace {

// Smallest share of all points that a part may have. Fewer fit some primitive by chance, and the
// part would be noise (of 3000 points: 24).
constexpr double kSmallestShare = 0.008;

// Fewest points of a part.
std::size_t smallest(const Surface& surface) {
  return std::max<std::size_t>(
      4, static_cast<std::size_t>(kSmallestShare * static_cast<double>(surface.whole)));
}

// A value for each point of a region, such as its coordinate along a direction.
using Values = std::vector<double>;

// Divides a region: the points whose value is below the limit are the first part.
struct Cut {
  const Values* values = nullptr;
  double limit = 0.0;
};

// The two parts, as indices of points.
struct Parts {
  std::vector<std::size_t> first;
  std::vector<std::size_t> second;
};

Parts parts_of(const Cut& cut) {
  Parts parts;
  for (std::size_t i = 0; i < cut.values->size(); ++i) {
    ((*cut.values)[i] < cut.limit ? parts.first : parts.second).push_back(i);
  }
  return parts;
}

// A cut with the quick fits to its parts. The cost is infinite where a part is too small, and where
// the cut was given up.
struct Candidate {
  Cut cut;
  Primitive first;
  Primitive second;
  double cost = std::numeric_limits<double>::infinity();
};

void lower(std::atomic<double>& bound, double cost) {
  double known = bound.load();
  while (cost < known && !bound.compare_exchange_weak(known, cost)) {
  }
}

// Cuts by planes orthogonal to a direction, by the points' coordinates along it.
struct Stations {
  Values along;
  double lowest = 0.0;
  double spacing = 0.0;
};

constexpr int kStations = 8;

Stations stations_along(const Vector3& direction, const Region& region) {
  Stations stations;
  for (const SurfacePoint& s : region.points) stations.along.push_back(direction.dot(s.p_O));
  const auto [low, high] = std::minmax_element(stations.along.begin(), stations.along.end());
  stations.lowest = *low;
  stations.spacing = (*high - *low) / (kStations + 1);
  return stations;
}

class SplitSearch {
 public:
  SplitSearch(const Region& region, const Surface& surface)
      : region_(region), surface_(surface), bound_(highest_worthwhile(region)) {}

  // The cheapest of these cuts and `best`, of several the first. All of them have to be worthwhile.
  Candidate cheapest(const std::vector<Cut>& cuts, Candidate best) {
    std::vector<Candidate> tried(cuts.size());
    for_each_in_parallel(cuts.size(), surface_.threads,
                         [&](std::size_t i) { tried[i] = candidate(cuts[i]); });
    for (Candidate& other : tried) {
      if (other.cost < best.cost) best = other;
    }
    return best;
  }

  // The cheapest of `best` and the cuts by planes along a direction: evenly spaced ones first, then
  // two halvings of the spacing around the best of them. That places a cut to 1/36 of the extent
  // with 12 candidates instead of 35.
  Candidate cheapest_plane(const Stations& stations, const Candidate& best) {
    const Values* along = &stations.along;
    std::vector<Cut> cuts;
    for (int i = 1; i <= kStations; ++i) {
      cuts.push_back({along, stations.lowest + stations.spacing * i});
    }
    Candidate found = cheapest(cuts, best);
    if (found.cut.values != along) return found;
    for (const double step : {0.5 * stations.spacing, 0.25 * stations.spacing}) {
      const double middle = found.cut.limit;
      found = cheapest({{along, middle - step}, {along, middle + step}}, found);
    }
    return found;
  }

 private:
  // A split that costs more than this does not lower the objective, whatever the shortfall.
  static double highest_worthwhile(const Region& region) {
    return region.fit.cost + kShortfallCost * region.unexplained - kPieceCost;
  }

  Candidate candidate(const Cut& cut) {
    const Parts parts = parts_of(cut);
    Candidate result{.cut = cut, .first = {}, .second = {}};
    if (std::min(parts.first.size(), parts.second.size()) < smallest(surface_)) return result;
    // The larger part first: it is the more likely to cost too much. Costs are not negative.
    const bool in_order = parts.first.size() >= parts.second.size();
    const Fit larger = fit_to(in_order ? parts.first : parts.second);
    if (larger.cost > bound_.load()) return result;
    const Fit smaller = fit_to(in_order ? parts.second : parts.first);
    const double cost = larger.cost + smaller.cost;
    if (cost > bound_.load()) return result;
    lower(bound_, cost);
    result.first = (in_order ? larger : smaller).primitive;
    result.second = (in_order ? smaller : larger).primitive;
    result.cost = cost;
    return result;
  }

  Fit fit_to(const std::vector<std::size_t>& part) const {
    const std::size_t count = std::min(part.size(), kQuickPoints);
    std::vector<SurfacePoint> few;
    few.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      few.push_back(region_.points[part[i * part.size() / count]]);
    }
    return quick_fit(few, share_of(part.size(), surface_), surface_);
  }

  const Region& region_;
  const Surface& surface_;
  std::atomic<double> bound_;  // no cut that costs more can be the best
};

// Directions of the planes to try: the principal axes of the points, and the axes of the primitive
// where they differ by more than 18 degrees. The latter matter for shapes like an L, which splits
// along its sides, while its principal axes are diagonal to them.
std::vector<Vector3> cut_directions(const Region& region) {
  constexpr double kSame = 0.95;  // cosine; 18 degrees
  std::vector<Vector3> directions;
  for (const Matrix3& frame :
       {point_axes(region.points), Matrix3(region.fit.primitive.X_OP.linear())}) {
    for (int i = 2; i >= 0; --i) {
      const Vector3 axis = frame.col(i);
      const bool known = std::any_of(directions.begin(), directions.end(), [&](const Vector3& d) {
        return std::abs(d.dot(axis)) > kSame;
      });
      if (!known) directions.push_back(axis);
    }
  }
  return directions;
}

Split split_by(const Candidate& candidate, const Region& region, const Surface& surface) {
  const Parts parts = parts_of(candidate.cut);
  std::vector<std::vector<SurfacePoint>> points(2);
  for (const std::size_t i : parts.first) points[0].push_back(region.points[i]);
  for (const std::size_t i : parts.second) points[1].push_back(region.points[i]);
  std::vector<Region> fitted =
      refitted(std::move(points), {candidate.first, candidate.second}, surface);
  return {std::move(fitted[0]), std::move(fitted[1])};
}

}  // namespace

std::optional<Split> best_split(const Region& region, const Surface& surface) {
  if (region.points.size() < 2 * smallest(surface)) return std::nullopt;
  SplitSearch search(region, surface);
  Candidate best;
  std::vector<Stations> directions;
  for (const Vector3& direction : cut_directions(region)) {
    directions.push_back(stations_along(direction, region));
  }
  for (const Stations& d : directions) best = search.cheapest_plane(d, best);
  // Points near the region's primitive against the rest: separates a protrusion (a handle) from a
  // body that no plane would cut off. Two widths of the band, since the rest near the seam is
  // within the full tolerance too.
  const Values distance = distances(region.fit.primitive, region.points);
  best =
      search.cheapest({{&distance, 0.5 * surface.tolerance}, {&distance, surface.tolerance}}, best);
  // The candidates were compared with quick fits; only the chosen one is fitted thoroughly.
  if (!std::isfinite(best.cost)) return std::nullopt;
  return split_by(best, region, surface);
}

}  // namespace prehend
