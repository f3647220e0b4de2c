#include "planner/path/time_curve.h"

#include <algorithm>
#include <cmath>

#include "planner/path/path_speed.h"

namespace prehend {
namespace {

using Points = std::vector<std::vector<double>>;

// The steps of timing a curve:
// 1. keep the joints that move and the waypoints that are apart, and lay a spline through them;
// 2. divide the spline into many stations and find the largest speed at each (path_speed.h);
// 3. integrate the speeds to the times of the stations;
// 4. read off samples at evenly spaced times.

// Fewest intervals between stations. Acceleration limits hold at stations only; this many make the
// excess between them small against what the final slowing down in time_path corrects.
constexpr std::size_t kIntervals = 2000;
// Fewest intervals between samples: a short motion is still described by nine samples.
constexpr int kFewestSteps = 8;
// Waypoints closer than this fraction of the path's length say nothing about its direction but
// rounding, and knots that close would make the spline swing.
constexpr double kSamePoint = 1e-9;

// Indices of joints that do not keep the same value at all waypoints. The others need no limits,
// and would divide by zero if they have none.
std::vector<std::size_t> moving_joints(const Points& waypoints) {
  std::vector<std::size_t> moving;
  for (std::size_t j = 0; j < waypoints.front().size(); ++j) {
    const bool moves = std::any_of(waypoints.begin(), waypoints.end(),
                                   [&](const auto& q) { return q[j] != waypoints.front()[j]; });
    if (moves) moving.push_back(j);
  }
  return moving;
}

std::vector<double> chosen(const std::vector<double>& values,
                           const std::vector<std::size_t>& which) {
  std::vector<double> some;
  some.reserve(which.size());
  for (const std::size_t j : which) some.push_back(values[j]);
  return some;
}

// Euclidean distance with each joint in units of its velocity limit [s]. Never 0, so that knots
// increase. Computed with hypot, because the squares of very short distances underflow to 0.
double distance(const std::vector<double>& from, const std::vector<double>& to,
                const std::vector<double>& velocity) {
  double length = 1e-150;
  for (std::size_t j = 0; j < from.size(); ++j) {
    length = std::hypot(length, (to[j] - from[j]) / velocity[j]);
  }
  return length;
}

// The points without those that are at the same place as the one kept before them. The first and
// the last stay: where the last is too close to the one before, it takes its place.
Points distinct_points(const Points& points, const std::vector<double>& velocity) {
  double total = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    total += distance(points[i - 1], points[i], velocity);
  }
  // Distances are to the last kept point, not to the neighbour: a long chain of tiny steps must not
  // be dropped as a whole.
  Points kept{points.front()};
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (distance(kept.back(), points[i], velocity) > kSamePoint * total) kept.push_back(points[i]);
  }
  kept.back() = points.back();
  return kept;
}

// The spline of the moving joints through the waypoints. Knots are chord lengths: a spline with
// evenly spaced knots would overshoot where the distances of the waypoints differ much.
PathSpline curve_through(const Points& waypoints, const JointLimits& limits,
                         const std::vector<std::size_t>& moving) {
  Points points;
  points.reserve(waypoints.size());
  for (const std::vector<double>& q : waypoints) points.push_back(chosen(q, moving));
  const std::vector<double> velocity = chosen(limits.velocity, moving);
  points = distinct_points(points, velocity);
  std::vector<double> knots{0.0};
  for (std::size_t i = 1; i < points.size(); ++i) {
    knots.push_back(knots.back() + distance(points[i - 1], points[i], velocity));
  }
  return {std::move(knots), std::move(points)};
}

// Stations at all knots, and evenly between two of them, as many in each interval. The third
// derivative of the spline jumps at a knot, so no interval between stations reaches across one.
std::vector<PathStation> stations_along(const PathSpline& curve) {
  const std::vector<double>& knots = curve.knots();
  const std::size_t parts = (kIntervals + knots.size() - 2) / (knots.size() - 1);
  std::vector<PathStation> stations;
  stations.reserve(parts * knots.size());
  const auto add = [&](double s) {
    CurvePoint point = curve.at(s);
    stations.push_back({s, std::move(point.dq), std::move(point.ddq)});
  };
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    for (std::size_t k = 0; k < parts; ++k) {
      add(knots[i] +
          (knots[i + 1] - knots[i]) * (static_cast<double>(k) / static_cast<double>(parts)));
    }
  }
  add(knots.back());
  return stations;
}

}  // namespace

// All of this is independent of the sampling, which time_path may repeat several times at lower
// speed.
CurveRun::CurveRun(const Points& waypoints, const JointLimits& limits)
    : moving_(moving_joints(waypoints)),
      start_(waypoints.front()),
      end_(waypoints.back()),
      curve_(curve_through(waypoints, limits, moving_)) {
  const std::vector<PathStation> stations = stations_along(curve_);
  const std::vector<double> squared = fastest_squared_speeds(
      stations, {chosen(limits.velocity, moving_), chosen(limits.acceleration, moving_)});
  double time = 0.0;
  for (std::size_t i = 0; i < stations.size(); ++i) {
    s_.push_back(stations[i].s);
    speeds_.push_back(std::sqrt(squared[i]));
    // At constant d2s/dt2 the mean speed of an interval is the mean of the speeds at its ends.
    if (i > 0) time += 2.0 * (s_[i] - s_[i - 1]) / (speeds_[i - 1] + speeds_[i]);
    times_.push_back(time);
  }
}

void CurveRun::add_sample(TimedPath& path, double s, double speed) const {
  const CurvePoint point = curve_.at(s);
  std::vector<double> position = start_;
  std::vector<double> velocity(start_.size(), 0.0);
  for (std::size_t j = 0; j < moving_.size(); ++j) {
    position[moving_[j]] = point.q[j];
    velocity[moving_[j]] = point.dq[j] * speed;
  }
  path.positions.push_back(std::move(position));
  path.velocities.push_back(std::move(velocity));
}

// A motion that is slower by a factor passes the same points at proportional times, so the samples
// are read from the fastest motion at the same fraction of its duration.
TimedPath CurveRun::sample(double slower, double sample_time) const {
  const double fastest = times_.back();
  const double duration = std::max(slower * fastest, kShortestMotion);
  const int steps = std::max(kFewestSteps, step_count(duration, sample_time));
  TimedPath path;
  std::size_t i = 0;
  for (int k = 0; k <= steps; ++k) {
    const double part = static_cast<double>(k) / steps;
    path.times.push_back(duration * part);
    // The same fraction of the fastest motion, and the interval of stations (i, i + 1) it is in.
    const double time = fastest * part;
    while (i + 2 < times_.size() && times_[i + 1] <= time) ++i;
    const double passed = time - times_[i];
    const double acceleration = (speeds_[i + 1] - speeds_[i]) / (times_[i + 1] - times_[i]);
    const double speed = speeds_[i] + acceleration * passed;
    // Mean speed times time is s_i + v_i t + a t^2 / 2; the clamp below is against rounding.
    const double s = s_[i] + 0.5 * (speeds_[i] + speed) * passed;
    add_sample(path, std::clamp(s, s_[i], s_[i + 1]), speed * (fastest / duration));
  }
  // At both ends the waypoint to the bit and exactly at rest, so that segments can be joined.
  for (const std::size_t end : {std::size_t{0}, path.times.size() - 1}) {
    path.positions[end] = end == 0 ? start_ : end_;
    path.velocities[end].assign(start_.size(), 0.0);
  }
  return path;
}

}  // namespace prehend
