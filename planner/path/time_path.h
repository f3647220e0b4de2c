// Time parametrisation: the fastest motion along a given path in joint space that keeps to the
// velocity and acceleration limits of the joints.
#pragma once

#include <string>
#include <vector>

#include "planner/path/trajectory.h"
#include "sim/base/settings.h"

namespace prehend {

// Velocity and acceleration limits: one number a joint, finite and > 0 for every joint that moves.
// Values of joints that do not move are ignored.
struct JointLimits {
  std::vector<double> velocity;      // rad/s or m/s
  std::vector<double> acceleration;  // rad/s^2 or m/s^2
};

// How the path runs between the waypoints.
enum class PathKind {
  corners,  // straight lines, with a full stop at each waypoint: a path of a sampling planner
  smooth,   // a curve with continuous second derivative, run through without a stop: for waypoints
            // that densely sample a smooth motion
};

struct TimePathOptions {
  // Longest time between two samples (> 0) [s].
  double sample_time = 0.02;
};

template <SettingsOf<TimePathOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [sample_time] = options;
  visit("sample_time", sample_time, kAbove0);
}

// A motion at rest at both ends. Time starts at 0 and increases.
struct TimedPath {
  std::vector<double> times;                   // s
  std::vector<std::vector<double>> positions;  // one row a sample, one number a joint [rad or m]
  std::vector<std::vector<double>> velocities;
};

// The fastest motion through `waypoints` (at least one, each with one number a joint).
//
// Every sample lies on the path; the last is the last waypoint, to the bit. At the samples no
// velocity exceeds its limit, nor does the difference of the velocities of two neighbouring samples
// over the time between them; an excess that discretisation leaves is removed by slowing down the
// motion as a whole.
//
// corners: the trapezoidal (or triangular) speed profile on each line, in closed form.
// Accelerating, cruising and braking are each divided evenly, so that the cubic between two samples
// is the motion itself. smooth: speeds by reachability analysis (path_speed.h) along a cubic spline
// (path_spline.h), samples evenly spaced, at least nine. Waypoints closer to the one before than
// 1e-9 of the path's length are left out. The cubic between two samples strays from the curve by
// microradians (8e-6 rad was measured at 20 ms and 1 to 3 rad/s), and where the motion switches
// between two samples its acceleration can be above the limit (1.66 times was measured).
//
// A path whose waypoints are all equal gives a single sample. A motion from stop to stop takes at
// least a microsecond.
// Throws InputError when waypoints are missing, ragged or not finite, a joint that moves has no
// limits, or they are so small that the motion would take ten million samples.
TimedPath time_path(const std::vector<std::vector<double>>& waypoints, PathKind kind,
                    const JointLimits& limits, const TimePathOptions& options = {});

// Shortest duration of a motion from stop to stop; a faster one is slowed down to it [s]. Then the
// times of its samples still differ where they are written in nanoseconds, and differences of
// velocities over time are not just rounding.
inline constexpr double kShortestMotion = 1e-6;

// The smallest number of equal steps of `duration`, at least 1, none of them longer than
// `sample_time`; both kinds of motion are divided by it. Throws InputError for more than ten
// million.
int step_count(double duration, double sample_time);

// Appends `path` to `trajectory` as a new segment with the name `segment`. Its times are shifted to
// start at the trajectory's last sample, and the sample where the two meet is kept once. A
// trajectory that has joints but no samples takes the path as it is. Throws InputError when the
// path does not start where the trajectory ends (within 1e-9 rad or m) or has another number of
// joints.
void append(Trajectory& trajectory, const std::string& segment, const TimedPath& path);

}  // namespace prehend
