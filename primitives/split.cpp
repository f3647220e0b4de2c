#include "primitives/split.h"

#include <algorithm>
#include <cmath>

#include "primitives/fit.h"

// A split is found by trying: every candidate divides the points in two, and a quick fit to each
// part tells what the two primitives would cost. The candidates are planes in a few directions at a
// few positions, and the separation of points near the region's primitive from all others.
namespace prehend {
namespace {

using Points = std::vector<SurfacePoint>;

// Smallest share of all points that a part may have. Fewer fit some primitive by chance, and the
// part would be noise (of 3000 points: 24).
constexpr double kSmallestShare = 0.008;

// A plane: points with direction.dot(p) < offset are on its first side.
struct Cut {
  Vector3 direction = Vector3::Zero();  // unit
  double offset = 0.0;
};

// Fewest points of a part.
std::size_t smallest(const Surface& surface) {
  return std::max<std::size_t>(
      4, static_cast<std::size_t>(kSmallestShare * static_cast<double>(surface.points.size())));
}

// Splits the region by a predicate, fits a primitive to each part quickly, and keeps the split in
// `best` if it is the cheapest so far. Returns whether it was kept. Costs are not negative, so the
// second part need not be fitted where the first alone costs as much as the best split.
template <class Predicate>
bool consider(const Region& region, const Surface& surface, const Predicate& in_first,
              std::optional<Split>& best) {
  Points first;
  Points second;
  for (const SurfacePoint& s : region.points) (in_first(s) ? first : second).push_back(s);
  if (std::min(first.size(), second.size()) < smallest(surface)) return false;
  Split split;
  split.first = fit_region(std::move(first), surface, Effort::quick);
  if (best && split.first.cost >= best->cost()) return false;
  split.second = fit_region(std::move(second), surface, Effort::quick);
  if (best && split.cost() >= best->cost()) return false;
  best = std::move(split);
  return true;
}

bool consider_cut(const Region& region, const Surface& surface, const Cut& cut,
                  std::optional<Split>& best) {
  return consider(
      region, surface,
      [&cut](const SurfacePoint& s) { return cut.direction.dot(s.p_O) < cut.offset; }, best);
}

// Cuts by planes orthogonal to `direction`.
void consider_cuts_along(const Vector3& direction, const Region& region, const Surface& surface,
                         std::optional<Split>& best) {
  // Evenly spaced cuts first, then two halvings of the spacing around the best of them: that places
  // a cut to 1/36 of the extent with 12 fits instead of 35.
  constexpr int kStations = 8;
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const SurfacePoint& s : region.points) {
    low = std::min(low, direction.dot(s.p_O));
    high = std::max(high, direction.dot(s.p_O));
  }
  double spacing = (high - low) / (kStations + 1);
  double at = 0.0;
  bool found = false;
  for (int i = 1; i <= kStations; ++i) {
    const double offset = low + spacing * i;
    if (consider_cut(region, surface, {direction, offset}, best)) {
      at = offset;
      found = true;
    }
  }
  if (!found) return;
  for (int halving = 0; halving < 2; ++halving) {
    spacing *= 0.5;
    const double middle = at;
    for (const double offset : {middle - spacing, middle + spacing}) {
      if (consider_cut(region, surface, {direction, offset}, best)) at = offset;
    }
  }
}

// Directions of the planes to try: the principal axes of the points, and the axes of the primitive
// where they differ by more than 18 degrees. The latter matter for shapes like an L, which splits
// along its sides, while its principal axes are diagonal to them.
std::vector<Vector3> cut_directions(const Region& region) {
  constexpr double kSame = 0.95;  // cosine; 18 degrees
  std::vector<Vector3> directions;
  for (const Matrix3& frame :
       {point_axes(region.points), Matrix3(region.primitive.X_OP.linear())}) {
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

}  // namespace

std::optional<Split> best_split(const Region& region, const Surface& surface) {
  std::optional<Split> best;
  if (region.points.size() < 2 * smallest(surface)) return best;
  for (const Vector3& direction : cut_directions(region)) {
    consider_cuts_along(direction, region, surface, best);
  }
  // Points near the region's primitive against the rest: separates a protrusion (a handle) from a
  // body that no plane would cut off. Two widths of the band, since the rest near the seam is
  // within the full tolerance too.
  for (const double share_of_tolerance : {0.5, 1.0}) {
    const double band = share_of_tolerance * surface.tolerance;
    consider(
        region, surface,
        [&](const SurfacePoint& s) {
          return std::abs(signed_distance(region.primitive, s.p_O)) < band;
        },
        best);
  }
  // The candidates were compared with quick fits; only the chosen one is fitted thoroughly.
  if (best) {
    best->first = refitted(std::move(best->first), surface);
    best->second = refitted(std::move(best->second), surface);
  }
  return best;
}

}  // namespace prehend
