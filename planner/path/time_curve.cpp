#include "planner/path/time_curve.h"

#include <algorithm>
#include <cmath>

#include "planner/path/path_speed.h"

namespace prehend {
namespace {

using Points = std::vector<std::vector<double>>;

// Fewest intervals that the curve is divided into.
constexpr std::size_t kIntervals = 2000;
// Fewest steps between samples.
constexpr int kFewestSteps = 8;
// Waypoints closer than this fraction of the path's length say nothing about its direction.
constexpr double kSamePoint = 1e-9;

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

// Seconds at full speed. Never 0, so that knots increase; hypot, because squares of short distances
// vanish.
double distance(const std::vector<double>& from, const std::vector<double>& to,
                const std::vector<double>& velocity) {
  double length = 1e-150;
  for (std::size_t j = 0; j < from.size(); ++j) {
    length = std::hypot(length, (to[j] - from[j]) / velocity[j]);
  }
  return length;
}

// Without those that are at the same place as the one before; the first and the last stay.
Points distinct_points(const Points& points, const std::vector<double>& velocity) {
  double total = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    total += distance(points[i - 1], points[i], velocity);
  }
  Points kept{points.front()};
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (distance(kept.back(), points[i], velocity) > kSamePoint * total) kept.push_back(points[i]);
  }
  kept.back() = points.back();
  return kept;
}

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

// At all knots, and evenly between two of them.
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

TimedPath CurveRun::sample(double slower, double sample_time) const {
  const double fastest = times_.back();
  const double duration = std::max(slower * fastest, kShortestMotion);
  const int steps = std::max(kFewestSteps, step_count(duration, sample_time));
  TimedPath path;
  std::size_t i = 0;
  for (int k = 0; k <= steps; ++k) {
    const double part = static_cast<double>(k) / steps;
    path.times.push_back(duration * part);
    const double time = fastest * part;
    while (i + 2 < times_.size() && times_[i + 1] <= time) ++i;
    const double passed = time - times_[i];
    const double acceleration = (speeds_[i + 1] - speeds_[i]) / (times_[i + 1] - times_[i]);
    const double speed = speeds_[i] + acceleration * passed;
    const double s = s_[i] + 0.5 * (speeds_[i] + speed) * passed;
    add_sample(path, std::clamp(s, s_[i], s_[i + 1]), speed * (fastest / duration));
  }
  for (const std::size_t end : {std::size_t{0}, path.times.size() - 1}) {
    path.positions[end] = end == 0 ? start_ : end_;
    path.velocities[end].assign(start_.size(), 0.0);
  }
  return path;
}

}  // namespace prehend
