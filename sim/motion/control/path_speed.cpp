#include "sim/motion/control/path_speed.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace prehend {
namespace {

// Time-optimal path parameterisation by reachability analysis. Along a given curve q(s) the only
// freedom is the speed s'. With x = s'^2, both the acceleration limits and the relation between
// neighbouring stations are linear in x, so that each step of the passes below is a linear program
// in one or two variables.

// Keeps the speed finite at a station where q' = 0: the velocity limits say nothing there. The
// curves of this library are parametrised in seconds at full speed, so that ds/dt is of the order
// of 1 and the bound of 100 does not slow down an ordinary motion.
constexpr double kLargestSquaredSpeed = 1e4;

// One acceleration limit of one joint on an interval between two stations:
// |at_start x + at_end y| <= bound, for the squared speeds x and y at its start and end.
struct Strip {
  double at_start;
  double at_end;
  double bound;
};

// Squared speeds at the start (x) and the end (y) of an interval.
struct Speeds {
  double x;
  double y;
};

// The acceleration limits on an interval. A joint's acceleration is q' s'' + q'' s'^2. With
// constant s'' = (y - x) / (2 ds) on the interval, it is linear in x and y; it is limited at the
// start (where s'^2 = x) and at the end (where s'^2 = y), which gives two strips for each joint.
// Limiting it at both ends keeps the solution from oscillating between stations (the interpolation
// scheme of section V).
std::vector<Strip> acceleration_strips(const PathStation& start, const PathStation& end,
                                       const std::vector<double>& limits) {
  const double twice = 2.0 * (end.s - start.s);
  std::vector<Strip> strips;
  strips.reserve(2 * limits.size());
  for (std::size_t j = 0; j < limits.size(); ++j) {
    const double before = start.dq[j] / twice;
    const double after = end.dq[j] / twice;
    strips.push_back({start.ddq[j] - before, before, start.pace * start.pace * limits[j]});
    strips.push_back({-after, after + end.ddq[j], end.pace * end.pace * limits[j]});
  }
  return strips;
}

// The largest squared speed at a station that the velocity limits allow. Products are compared
// instead of quotients, so that a joint with slope 0 is not divided by.
double velocity_bound(const PathStation& station, const std::vector<double>& limits) {
  double speed = std::sqrt(kLargestSquaredSpeed);
  for (std::size_t j = 0; j < limits.size(); ++j) {
    const double slope = std::abs(station.dq[j]);
    if (limits[j] < speed * slope) speed = limits[j] / slope;
  }
  speed *= station.pace;
  return speed * speed;
}

// Cuts off the part of a convex polygon where a x + b y > c (Sutherland and Hodgman 1974).
void clip(std::vector<Speeds>& polygon, double a, double b, double c) {
  std::vector<Speeds> kept;
  kept.reserve(polygon.size() + 1);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Speeds& from = polygon[i];
    const Speeds& to = polygon[(i + 1) % polygon.size()];
    const double over_from = a * from.x + b * from.y - c;
    const double over_to = a * to.x + b * to.y - c;
    if (over_from <= 0.0) kept.push_back(from);
    if ((over_from < 0.0 && over_to > 0.0) || (over_from > 0.0 && over_to < 0.0)) {
      const double t = over_from / (over_from - over_to);
      kept.push_back({from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)});
    }
  }
  polygon.swap(kept);
}

// The largest x <= x_bound from which some y in [0, y_bound] can be reached: a linear program in
// two variables, solved by clipping the rectangle of bounds with each strip. The feasible pairs are
// a convex polygon that contains the origin, so all smaller x are feasible as well.
double largest_start(const std::vector<Strip>& strips, double x_bound, double y_bound) {
  std::vector<Speeds> polygon{{0.0, 0.0}, {x_bound, 0.0}, {x_bound, y_bound}, {0.0, y_bound}};
  for (const Strip& strip : strips) {
    const double reach = std::abs(strip.at_start) * x_bound + std::abs(strip.at_end) * y_bound;
    if (reach <= strip.bound) continue;  // contains the whole rectangle: nothing to cut off
    clip(polygon, strip.at_start, strip.at_end, strip.bound);
    clip(polygon, -strip.at_start, -strip.at_end, strip.bound);
  }
  double largest = 0.0;
  for (const Speeds& corner : polygon) largest = std::max(largest, corner.x);
  return largest;
}

// The largest y in [0, y_bound] that the strips allow for a given x. The backward pass made sure
// that one exists; the final max is against rounding only.
double largest_end(const std::vector<Strip>& strips, double x, double y_bound) {
  double y = y_bound;
  for (const Strip& strip : strips) {
    const double most =
        strip.at_end > 0.0 ? strip.bound - strip.at_start * x : strip.bound + strip.at_start * x;
    const double slope = std::abs(strip.at_end);
    if (most < y * slope) y = most / slope;
  }
  return std::max(y, 0.0);
}

}  // namespace

std::vector<double> fastest_squared_speeds(const std::vector<PathStation>& stations,
                                           const JointLimits& limits) {
  assert(stations.size() >= 2);
  // Backward: reachable[i] is the largest squared speed at station i from which the motion can
  // still stop at the end. Forward: from rest, the largest such speed at each next station. All
  // speeds from 0 to reachable[i] can stop as well, so the forward pass never gets stuck; that this
  // greedy choice is time-optimal (up to the discretisation) is shown in the source.
  const std::size_t last = stations.size() - 1;
  std::vector<std::vector<Strip>> strips(last);
  std::vector<double> reachable(last + 1, 0.0);  // 0 at the end, where the motion stops
  for (std::size_t i = last; i-- > 0;) {
    strips[i] = acceleration_strips(stations[i], stations[i + 1], limits.acceleration);
    const double bound = velocity_bound(stations[i], limits.velocity);
    reachable[i] = largest_start(strips[i], bound, reachable[i + 1]);
  }
  std::vector<double> squared(last + 1, 0.0);
  for (std::size_t i = 0; i < last; ++i) {
    squared[i + 1] = largest_end(strips[i], squared[i], reachable[i + 1]);
  }
  return squared;
}

}  // namespace prehend
