#include "planner/path/time_corners.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace prehend {
namespace {

// On a straight line in joint space all joints move in proportion to one scalar, the fraction of
// the line that is covered. The profile is computed once for this fraction, with the tightest
// velocity and acceleration limit of all joints, and every joint follows it.

// A trapezoidal speed profile from rest to rest: accelerating takes `ramp` seconds, and so does
// braking; between them the speed is constant for `cruise` seconds. Without cruise it is a
// triangle.
struct Trapezoid {
  double ramp = 0.0;
  double cruise = 0.0;
};

// How far along the line, as a fraction of it, and how fast [1/s].
struct LinePoint {
  double fraction = 0.0;
  double rate = 0.0;
};

// The fastest trapezoid for the fraction: speed and acceleration of each joint are the fraction's
// times the joint's distance, so the joint that is tightest sets them.
Trapezoid fastest_trapezoid(const std::vector<double>& from, const std::vector<double>& to,
                            const JointLimits& limits) {
  double speed = std::numeric_limits<double>::infinity();
  double acceleration = std::numeric_limits<double>::infinity();
  for (std::size_t j = 0; j < from.size(); ++j) {
    const double distance = std::abs(to[j] - from[j]);
    if (distance == 0.0) continue;
    speed = std::min(speed, limits.velocity[j] / distance);
    acceleration = std::min(acceleration, limits.acceleration[j] / distance);
  }
  // Accelerating to `speed` and braking covers speed^2 / acceleration of the line. If that is all
  // of it or more, the top speed is not reached and the profile is a triangle.
  Trapezoid trapezoid;
  if (speed * speed >= acceleration) {
    trapezoid.ramp = std::sqrt(1.0 / acceleration);
  } else {
    trapezoid.ramp = speed / acceleration;
    trapezoid.cruise = 1.0 / speed - trapezoid.ramp;
  }
  // Phases too short to sample: a cruise becomes part of the ramps, at the same greatest speed.
  if (trapezoid.cruise < kShortestMotion) {
    trapezoid.ramp += trapezoid.cruise;
    trapezoid.cruise = 0.0;
  }
  trapezoid.ramp = std::max(trapezoid.ramp, 0.5 * kShortestMotion);
  return trapezoid;
}

// Appends samples of the motion along one line to a path, one phase of the trapezoid at a time.
// Each phase starts and ends at a sample: the acceleration is then constant between any two
// samples, and the cubic between them is the motion itself.
class LineSampler {
 public:
  LineSampler(const std::vector<double>& from, const std::vector<double>& to, TimedPath& path)
      : from_(from), to_(to), path_(path), start_(path.times.back()) {}

  void run(const Trapezoid& trapezoid, double sample_time) {
    const double ramp = trapezoid.ramp;
    const double peak = 1.0 / (ramp + trapezoid.cruise);  // the area under the trapezoid is 1
    const double ramp_fraction = 0.5 * peak * ramp;
    phase(ramp, sample_time, [&](double t) {
      return LinePoint{ramp_fraction * (t * t), peak * t};
    });
    phase(trapezoid.cruise, sample_time, [&](double t) {
      return LinePoint{ramp_fraction + peak * trapezoid.cruise * t, peak};
    });
    phase(ramp, sample_time, [&](double t) {
      const double left = 1.0 - t;
      return LinePoint{1.0 - ramp_fraction * (left * left), peak * left};
    });
    // The end to the bit: the sums above round, and the next line starts at exactly this waypoint.
    path_.positions.back() = to_;
  }

 private:
  // Samples one phase at equal steps of time. `progress_at` maps the elapsed fraction of the phase,
  // in (0, 1], to the point on the line.
  template <typename ProgressAt>
  void phase(double duration, double sample_time, const ProgressAt& progress_at) {
    const int steps = duration > 0.0 ? step_count(duration, sample_time) : 0;
    for (int k = 1; k <= steps; ++k) {
      const double t = static_cast<double>(k) / steps;
      add(start_ + duration * t, progress_at(t));
    }
    start_ += duration;
  }

  void add(double time, const LinePoint& progress) {
    path_.times.push_back(time);
    std::vector<double> position(from_.size());
    std::vector<double> velocity(from_.size());
    for (std::size_t j = 0; j < from_.size(); ++j) {
      position[j] = from_[j] + (to_[j] - from_[j]) * progress.fraction;
      velocity[j] = (to_[j] - from_[j]) * progress.rate;
    }
    path_.positions.push_back(std::move(position));
    path_.velocities.push_back(std::move(velocity));
  }

  const std::vector<double>& from_;
  const std::vector<double>& to_;
  TimedPath& path_;
  double start_;  // of the phase [s]
};

}  // namespace

TimedPath time_corners(const std::vector<std::vector<double>>& waypoints, const JointLimits& limits,
                       double slower, double sample_time) {
  TimedPath path;
  path.times.push_back(0.0);
  path.positions.push_back(waypoints.front());
  path.velocities.emplace_back(waypoints.front().size(), 0.0);
  for (std::size_t i = 1; i < waypoints.size(); ++i) {
    // On a line of no length nothing limits the speed.
    if (waypoints[i] == waypoints[i - 1]) continue;
    Trapezoid trapezoid = fastest_trapezoid(waypoints[i - 1], waypoints[i], limits);
    trapezoid.ramp *= slower;
    trapezoid.cruise *= slower;
    LineSampler(waypoints[i - 1], waypoints[i], path).run(trapezoid, sample_time);
  }
  return path;
}

}  // namespace prehend
