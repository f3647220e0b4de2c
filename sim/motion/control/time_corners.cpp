#include "sim/motion/control/time_corners.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/motion/control/smooth_steps.h"

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

  double duration() const { return 2.0 * ramp + cruise; }

  // The fraction of the line that is covered after `time` seconds.
  double fraction(double time) const {
    if (2.0 * time > duration()) {
      return time >= duration() ? 1.0 : 1.0 - fraction(duration() - time);
    }
    if (time <= 0.0) return 0.0;
    const double peak = 1.0 / (ramp + cruise);  // the area under the trapezoid is 1
    return time < ramp ? 0.5 * peak * time * (time / ramp) : peak * (time - 0.5 * ramp);
  }
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
  trapezoid.ramp = std::max(trapezoid.ramp, 0.5 * kShortestMotion);
  return trapezoid;
}

// Appends the motion along one line, in equal steps of time. All joints move in proportion, so it
// is enough to smooth the fraction (smooth_steps.h), which adds a step at either end.
void add_line(TimedPath& path, const std::vector<double>& from, const std::vector<double>& to,
              const Trapezoid& trapezoid, double sample_time) {
  const double start = path.times.back();
  const int steps = step_count(trapezoid.duration(), sample_time);
  const double step = trapezoid.duration() / steps;
  const auto at = [&](int k) {
    if (k <= 0) return 0.0;
    return k >= steps ? 1.0 : trapezoid.fraction(step * k);
  };
  for (int k = 1; k <= steps + 2; ++k) {
    const SmoothValue progress = smoothed(at, k - 1, step);
    path.times.push_back(start + step * k);
    std::vector<double> position(from.size());
    std::vector<double> velocity(from.size());
    for (std::size_t j = 0; j < from.size(); ++j) {
      position[j] = from[j] + (to[j] - from[j]) * progress.value;
      velocity[j] = (to[j] - from[j]) * progress.rate;
    }
    path.positions.push_back(std::move(position));
    path.velocities.push_back(std::move(velocity));
  }
  path.positions.back() = to;  // to the bit: the next line starts there
}

}  // namespace

TimedPath time_corners(const std::vector<std::vector<double>>& waypoints, const JointLimits& limits,
                       double sample_time) {
  TimedPath path;
  path.times.push_back(0.0);
  path.positions.push_back(waypoints.front());
  path.velocities.emplace_back(waypoints.front().size(), 0.0);
  for (std::size_t i = 1; i < waypoints.size(); ++i) {
    // On a line of no length nothing limits the speed.
    if (waypoints[i] == waypoints[i - 1]) continue;
    add_line(path, waypoints[i - 1], waypoints[i],
             fastest_trapezoid(waypoints[i - 1], waypoints[i], limits), sample_time);
  }
  return path;
}

}  // namespace prehend
