#include "primitives/spot_curves.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

#include <Eigen/Eigenvalues>

#include "sim/base/disjoint_sets.h"
#include "sim/base/index.h"

namespace prehend {
namespace {

constexpr std::size_t kFewestSpots = 6;
constexpr std::size_t kPlaces = 32;  // on a curve

using Spots = std::vector<ThinSpot>;

bool belong_together(const ThinSpot& a, const ThinSpot& b, double link) {
  constexpr double kSameWay = 0.6;  // cosine
  constexpr double kSameWidth = 3.0;
  if ((a.p - b.p).squaredNorm() > link * link) return false;
  if (std::max(a.width, b.width) > kSameWidth * std::min(a.width, b.width)) return false;
  // A bar has no sense of direction.
  const double same = a.into.dot(b.into);
  const bool is_bar = a.across.isZero();
  return (is_bar ? std::abs(same) : same) > kSameWay;
}

std::vector<Spots> connected(const Spots& spots, double link) {
  DisjointSets sets(spots.size());
  for (std::size_t i = 0; i < spots.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (belong_together(spots[i], spots[j], link)) sets.merge(i, j);
    }
  }
  std::vector<Spots> groups(spots.size());
  for (std::size_t i = 0; i < spots.size(); ++i) groups[sets.find(i)].push_back(spots[i]);
  std::erase_if(groups, [](const Spots& group) { return group.size() < kFewestSpots; });
  return groups;
}

// Spots in their order along the curve, each at a parameter that grows with it.
struct Ordered {
  Spots spots;
  std::vector<double> at;
  double period = 0.0;  // of the parameter of a closed curve
};

void sort(Ordered& curve) {
  std::vector<std::size_t> order(curve.spots.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return curve.at[a] < curve.at[b]; });
  Ordered sorted{{}, {}, curve.period};
  for (const std::size_t i : order) {
    sorted.spots.push_back(curve.spots[i]);
    sorted.at.push_back(curve.at[i]);
  }
  curve = std::move(sorted);
}

// By their angle about their middle, in the plane in which they spread most.
Ordered by_angle(const Spots& spots) {
  Vector3 middle = Vector3::Zero();
  for (const ThinSpot& s : spots) middle += s.p / static_cast<double>(spots.size());
  Matrix3 spread = Matrix3::Zero();
  for (const ThinSpot& s : spots) spread += (s.p - middle) * (s.p - middle).transpose();
  const Matrix3 axes = Eigen::SelfAdjointEigenSolver<Matrix3>(spread).eigenvectors();
  Ordered curve{spots, {}, 2.0 * std::numbers::pi};
  for (const ThinSpot& s : spots) {
    curve.at.push_back(std::atan2(axes.col(1).dot(s.p - middle), axes.col(2).dot(s.p - middle)));
  }
  sort(curve);
  return curve;
}

double widest_gap(const Ordered& curve) {
  double gap = curve.at.front() + curve.period - curve.at.back();
  for (std::size_t i = 1; i < curve.at.size(); ++i) {
    gap = std::max(gap, curve.at[i] - curve.at[i - 1]);
  }
  return gap;
}

// Lengths of the shortest ways from a spot to all others, by steps between spots that are linked
// (Dijkstra).
std::vector<double> ways_from(std::size_t start, const Spots& spots, double link) {
  std::vector<double> way(spots.size(), std::numeric_limits<double>::infinity());
  std::vector<bool> done(spots.size(), false);
  way[start] = 0.0;
  for (std::size_t round = 0; round < spots.size(); ++round) {
    std::size_t next = spots.size();
    for (std::size_t i = 0; i < spots.size(); ++i) {
      if (!done[i] && (next == spots.size() || way[i] < way[next])) next = i;
    }
    done[next] = true;
    for (std::size_t i = 0; i < spots.size(); ++i) {
      const double step = (spots[i].p - spots[next].p).norm();
      if (step <= link) way[i] = std::min(way[i], way[next] + step);
    }
  }
  return way;
}

// By their way from one end: the spot that is farthest from any other.
Ordered by_way(const Spots& spots, double link) {
  const std::vector<double> from_any = ways_from(0, spots, link);
  const auto end = std::max_element(from_any.begin(), from_any.end()) - from_any.begin();
  Ordered curve{spots, ways_from(static_cast<std::size_t>(end), spots, link), 0.0};
  sort(curve);
  return curve;
}

// Directions that are known up to their sign follow those before.
void make_continuous(Ordered& curve) {
  for (std::size_t i = 1; i < curve.spots.size(); ++i) {
    ThinSpot& spot = curve.spots[i];
    const ThinSpot& before = curve.spots[i - 1];
    if (spot.across.dot(before.across) < 0.0) spot.across = -spot.across;
    if (spot.across.isZero() && spot.into.dot(before.into) < 0.0) spot.into = -spot.into;
  }
}

// The mean of the spots near a parameter, weighted by how near they are.
ThinSpot smoothed(const Ordered& curve, double at, double window) {
  ThinSpot mean;
  double sum = 0.0;
  const ThinSpot* nearest = &curve.spots.front();
  double most = 0.0;
  std::vector<double> weights;
  for (std::size_t i = 0; i < curve.spots.size(); ++i) {
    double off = std::abs(curve.at[i] - at);
    if (curve.period > 0.0) off = std::min(off, curve.period - off);
    const double weight = std::exp(-0.5 * off * off / (window * window)) + 1e-30 / (1.0 + off);
    weights.push_back(weight);
    if (weight > most) nearest = &curve.spots[i];
    most = std::max(most, weight);
  }
  for (std::size_t i = 0; i < curve.spots.size(); ++i) {
    const ThinSpot& spot = curve.spots[i];
    const double sign = spot.across.dot(nearest->across) < 0.0 ? -1.0 : 1.0;
    mean.p += weights[i] * spot.p;
    mean.into += weights[i] * spot.into;
    mean.across += sign * weights[i] * spot.across;
    mean.width += weights[i] * spot.width;
    mean.depth += weights[i] * spot.depth;
    sum += weights[i];
  }
  mean.p /= sum;
  mean.width /= sum;
  mean.depth /= sum;
  mean.into = mean.into.norm() > 0.0 ? Vector3(mean.into.normalized()) : nearest->into;
  if (nearest->across.isZero()) return mean;
  mean.across -= mean.into * mean.into.dot(mean.across);
  mean.across =
      mean.across.norm() > 0.0 ? Vector3(mean.across.normalized()) : any_orthogonal(mean.into);
  return mean;
}

// Between spots that lie far apart the curve stands still: places that are as good as the one
// before tell nothing, and have no direction along the curve.
void remove_repeated_places(SpotCurve& curve) {
  const double apart = 1e-6 * curve.length;
  std::vector<ThinSpot> places;
  for (const ThinSpot& place : curve.places) {
    if (places.empty() || (place.p - places.back().p).norm() > apart) places.push_back(place);
  }
  const bool ends_at_start = (places.front().p - places.back().p).norm() <= apart;
  if (curve.closed && places.size() > 1 && ends_at_start) places.pop_back();
  curve.places = std::move(places);
}

SpotCurve curve_through(const Spots& spots, double link) {
  constexpr double kWidestGap = 0.25 * std::numbers::pi;
  SpotCurve curve;
  Ordered ordered = by_angle(spots);
  curve.closed = widest_gap(ordered) < kWidestGap;
  if (!curve.closed) ordered = by_way(spots, link);
  make_continuous(ordered);
  const double first = ordered.at.front();
  const double whole = curve.closed ? ordered.period : ordered.at.back() - first;
  const double step = whole / static_cast<double>(curve.closed ? kPlaces : kPlaces - 1);
  for (std::size_t k = 0; k < kPlaces; ++k) {
    const double at = first + step * static_cast<double>(k);
    curve.places.push_back(smoothed(ordered, at, 0.5 * step));
    if (k == 0) continue;
    if (curve.places[k].across.dot(curve.places[k - 1].across) < 0.0) {
      curve.places[k].across = -curve.places[k].across;
    }
    curve.length += (curve.places[k].p - curve.places[k - 1].p).norm();
  }
  if (curve.closed) curve.length += (curve.places.front().p - curve.places.back().p).norm();
  remove_repeated_places(curve);
  return curve;
}

}  // namespace

std::vector<SpotCurve> spot_curves(const std::vector<ThinSpot>& spots, double link,
                                   double shortest) {
  std::vector<SpotCurve> curves;
  for (const Spots& group : connected(spots, link)) {
    SpotCurve curve = curve_through(group, link);
    if (curve.places.size() > 1 && curve.length >= shortest) curves.push_back(std::move(curve));
  }
  std::stable_sort(curves.begin(), curves.end(),
                   [](const SpotCurve& a, const SpotCurve& b) { return a.length > b.length; });
  return curves;
}

}  // namespace prehend
