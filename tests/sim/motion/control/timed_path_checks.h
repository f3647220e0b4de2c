// What is promised of every timed path, and paths whose motion is known.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "sim/base/random.h"
#include "sim/motion/control/time_path.h"

namespace prehend::test {

using Points = std::vector<std::vector<double>>;

inline double difference(const TimedPath& path, std::size_t i, std::size_t joint) {
  return (path.velocities[i][joint] - path.velocities[i - 1][joint]) /
         (path.times[i] - path.times[i - 1]);
}

// Velocity and acceleration on the cubic between samples i - 1 and i, at the fraction t of the time
// between them: the derivatives of Hermite's basis functions.
inline double velocity_at(const TimedPath& path, std::size_t i, std::size_t j, double t) {
  const double h = path.times[i] - path.times[i - 1];
  const double change = path.positions[i][j] - path.positions[i - 1][j];
  return 6.0 * t * (1.0 - t) * change / h +
         (1.0 - 4.0 * t + 3.0 * t * t) * path.velocities[i - 1][j] +
         (3.0 * t * t - 2.0 * t) * path.velocities[i][j];
}

inline double acceleration_at(const TimedPath& path, std::size_t i, std::size_t j, double t) {
  const double h = path.times[i] - path.times[i - 1];
  const double change = path.positions[i][j] - path.positions[i - 1][j];
  return (6.0 - 12.0 * t) * change / (h * h) + (6.0 * t - 4.0) * path.velocities[i - 1][j] / h +
         (6.0 * t - 2.0) * path.velocities[i][j] / h;
}

// What rounding of the positions makes of the acceleration on a cubic.
inline double acceleration_noise(const TimedPath& path, std::size_t i, std::size_t j) {
  const double h = path.times[i] - path.times[i - 1];
  const double size = std::abs(path.positions[i][j]) + std::abs(path.positions[i - 1][j]);
  return 6.0 * 2.3e-16 * size / (h * h);
}

// Both are within the limits between the samples as well, and at rest at both ends; no acceleration
// jumps.
inline void expect_kept_between(const TimedPath& path, const JointLimits& limits) {
  for (std::size_t i = 1; i < path.times.size(); ++i) {
    for (std::size_t j = 0; j < limits.velocity.size(); ++j) {
      if (path.positions[i][j] == path.positions[i - 1][j] && path.velocities[i][j] == 0.0 &&
          path.velocities[i - 1][j] == 0.0) {
        continue;
      }
      const double noise = acceleration_noise(path, i, j);
      const double step = path.times[i] - path.times[i - 1];
      for (int k = 0; k <= 20; ++k) {
        ASSERT_LE(std::abs(velocity_at(path, i, j, k / 20.0)),
                  limits.velocity[j] * (1.0 + 1e-6) + noise * step)
            << i << ' ' << j;
        ASSERT_LE(std::abs(acceleration_at(path, i, j, k / 20.0)),
                  limits.acceleration[j] * (1.0 + 1e-6) + noise)
            << i << ' ' << j;
      }
      const double after = i + 1 < path.times.size() ? acceleration_at(path, i + 1, j, 0.0) : 0.0;
      const double at_ends = i + 1 < path.times.size() && path.velocities[i][j] != 0.0 ? 1e-3 : 0.1;
      const double noise_after =
          i + 1 < path.times.size() ? acceleration_noise(path, i + 1, j) : noise;
      ASSERT_NEAR(acceleration_at(path, i, j, 1.0), after,
                  at_ends * limits.acceleration[j] + noise + noise_after)
          << i << ' ' << j;
    }
  }
}

// What is promised of every timed path.
inline void expect_kept(const TimedPath& path, const Points& waypoints, const JointLimits& limits,
                        double sample_time = 0.02) {
  ASSERT_EQ(path.times.size(), path.positions.size());
  ASSERT_EQ(path.times.size(), path.velocities.size());
  EXPECT_EQ(path.times.front(), 0.0);
  EXPECT_EQ(path.positions.front(), waypoints.front());
  EXPECT_EQ(path.positions.back(), waypoints.back());
  const std::vector<double> rest(waypoints.front().size(), 0.0);
  EXPECT_EQ(path.velocities.front(), rest);
  EXPECT_EQ(path.velocities.back(), rest);
  for (std::size_t i = 0; i < path.times.size(); ++i) {
    for (std::size_t j = 0; j < rest.size(); ++j) {
      ASSERT_LE(std::abs(path.velocities[i][j]), limits.velocity[j] * (1.0 + 1e-9))
          << i << ' ' << j;
      if (i == 0) continue;
      ASSERT_LE(std::abs(difference(path, i, j)), limits.acceleration[j] * (1.0 + 1e-6))
          << i << ' ' << j;
    }
    if (i == 0) continue;
    ASSERT_GT(path.times[i], path.times[i - 1]) << i;
    ASSERT_LE(path.times[i] - path.times[i - 1], sample_time * (1.0 + 1e-9)) << i;
  }
  expect_kept_between(path, limits);
}

// Of a motion from stop to stop that takes `seconds` before it is smoothed.
inline double smoothed_time(double seconds, double sample_time = 0.02) {
  return seconds + 2.0 * seconds / std::max(16.0, std::ceil(seconds / sample_time));
}

// The cubic between samples i - 1 and i, at the fraction t of the time between them.
inline std::vector<double> interpolated(const TimedPath& path, std::size_t i, double t) {
  const double h = path.times[i] - path.times[i - 1];
  std::vector<double> q(path.positions[i].size());
  for (std::size_t j = 0; j < q.size(); ++j) {
    const double change = path.positions[i][j] - path.positions[i - 1][j];
    q[j] = path.positions[i - 1][j] + t * t * (3.0 - 2.0 * t) * change +
           h * t * (1.0 - t) * ((1.0 - t) * path.velocities[i - 1][j] - t * path.velocities[i][j]);
  }
  return q;
}

// Rest to rest over a distance: half of it at full acceleration, or with a cruise at full speed.
inline double trapezoid_time(double distance, double velocity, double acceleration) {
  if (velocity * velocity >= distance * acceleration) {
    return 2.0 * std::sqrt(distance / acceleration);
  }
  return distance / velocity + velocity / acceleration;
}

// Where the one who takes the trapezoid is at `time`.
inline double trapezoid_position(double time, double distance, double velocity,
                                 double acceleration) {
  const double total = trapezoid_time(distance, velocity, acceleration);
  if (2.0 * time > total) {
    return distance - trapezoid_position(total - time, distance, velocity, acceleration);
  }
  const double ramp = velocity / acceleration;
  if (time <= ramp) return 0.5 * acceleration * time * time;
  return 0.5 * velocity * ramp + velocity * (time - ramp);
}

// A curve of seven joints: a sine each.
class SineCurve {
 public:
  explicit SineCurve(std::uint64_t seed) {
    Random random(seed);
    for (std::size_t j = 0; j < 7; ++j) {
      amplitude_.push_back(random.uniform(0.1, 1.0));
      frequency_.push_back(random.uniform(0.5, 6.0));
      phase_.push_back(random.uniform(0.0, 2.0 * std::numbers::pi));
      limits_.velocity.push_back(random.uniform(1.0, 3.0));
      limits_.acceleration.push_back(random.uniform(5.0, 20.0));
    }
  }

  std::vector<double> at(double u) const {
    std::vector<double> q;
    for (std::size_t j = 0; j < amplitude_.size(); ++j) {
      q.push_back(amplitude_[j] * std::sin(frequency_[j] * u + phase_[j]));
    }
    return q;
  }

  Points points(int count) const {
    Points points;
    for (int i = 0; i < count; ++i) points.push_back(at(static_cast<double>(i) / (count - 1)));
    return points;
  }

  // Distance to the nearest point of the curve, by the golden section around the best of many.
  double distance(const std::vector<double>& q) const {
    constexpr int kSteps = 400;
    int best = 0;
    for (int i = 1; i <= kSteps; ++i) {
      if (gap(q, static_cast<double>(i) / kSteps) < gap(q, static_cast<double>(best) / kSteps)) {
        best = i;
      }
    }
    double low = std::max(0, best - 1) / static_cast<double>(kSteps);
    double high = std::min(kSteps, best + 1) / static_cast<double>(kSteps);
    for (int i = 0; i < 60; ++i) {
      const double a = high - (high - low) / std::numbers::phi;
      const double b = low + (high - low) / std::numbers::phi;
      (gap(q, a) < gap(q, b) ? high : low) = gap(q, a) < gap(q, b) ? b : a;
    }
    return gap(q, 0.5 * (low + high));
  }

  const JointLimits& limits() const { return limits_; }

 private:
  double gap(const std::vector<double>& q, double u) const {
    const std::vector<double> p = at(u);
    double sum = 0.0;
    for (std::size_t j = 0; j < q.size(); ++j) sum += (p[j] - q[j]) * (p[j] - q[j]);
    return std::sqrt(sum);
  }

  std::vector<double> amplitude_, frequency_, phase_;
  JointLimits limits_;
};

// Part of the steps in which some joint is at a limit (within 2 % of velocity, 5 % of
// acceleration).
inline double limited_part(const TimedPath& path, const JointLimits& limits) {
  int limited = 0;
  for (std::size_t i = 1; i < path.times.size(); ++i) {
    bool at_limit = false;
    for (std::size_t j = 0; j < limits.velocity.size(); ++j) {
      at_limit |= std::abs(path.velocities[i][j]) >= 0.98 * limits.velocity[j];
      at_limit |= std::abs(difference(path, i, j)) >= 0.95 * limits.acceleration[j];
    }
    if (at_limit) ++limited;
  }
  return limited / static_cast<double>(path.times.size() - 1);
}

}  // namespace prehend::test
