#include "sim/quality/wrench_hull.h"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "sim/quality/quickhull.h"
#include "sim/quality/start_simplex.h"
#include "sim/quality/wrench_size.h"

namespace prehend {
namespace {

// The hull of wrenches whose volume may not be in the range of doubles, from that of the same
// wrenches times 2^-exponent. Powers of two scale without rounding. Lengths are scaled back by the
// factor, the volume in six dimensions by its sixth power; unit normals stay as they are.
WrenchHull from_scaled(const Wrenches& wrenches, int exponent) {
  WrenchHull hull = wrench_hull(times_power_of_two(wrenches, -exponent));
  hull.min_offset = std::ldexp(hull.min_offset, exponent);
  hull.volume = std::ldexp(hull.volume, 6 * exponent);
  hull.weakest = times_power_of_two(hull.weakest, exponent);
  hull.doubt = std::ldexp(hull.doubt, exponent);
  for (double& offset : hull.points.offsets) offset = std::ldexp(offset, exponent);
  hull.points.reach = std::ldexp(hull.points.reach, exponent);
  hull.points.volume = hull.volume;
  hull.points.joggle = std::ldexp(hull.points.joggle, exponent);
  return hull;
}

}  // namespace

WrenchHull wrench_hull(const Wrenches& wrenches) {
  if (wrenches.cols() == 0) return {};
  const int exponent = excess_exponent(wrenches);
  if (exponent != 0) return from_scaled(wrenches, exponent);
  // The same test of flatness as in the search for epsilon, so that both agree on which sets are
  // flat; qhull's own threshold is another one. The search for the simplex must not stop where the
  // origin is outside: there is a volume even then.
  const StartSimplex start = start_simplex(ColumnSupport(wrenches), false);
  if (start.flat) return {};
  PointHull points = quickhull(wrenches, start);
  if (points.status == PointHullStatus::failed) points = point_hull(wrenches);
  if (points.status == PointHullStatus::failed) points = point_hull(wrenches, HullInput::joggled);
  if (points.status == PointHullStatus::failed) {
    throw std::runtime_error("qhull: " + points.message);
  }
  if (points.status == PointHullStatus::flat) return {};
  WrenchHull hull;
  hull.status = HullStatus::solid;
  hull.volume = points.volume;
  Eigen::Index nearest = 0;
  hull.min_offset = points.offsets.minCoeff(&nearest);
  hull.weakest = -hull.min_offset * points.normals.col(nearest);
  // Each of the six coordinates of a point is joggled by at most `joggle`, so no point, and no
  // facet, moves by more than sqrt(6) times that.
  hull.doubt = kFlatness * start.scale + std::sqrt(6.0) * points.joggle;
  hull.points = std::move(points);
  return hull;
}

}  // namespace prehend
