// Time parametrisation: a fast motion along a given path in joint space that keeps to the velocity
// and acceleration limits of the joints, with continuous velocity and acceleration.
#pragma once

#include <string>
#include <vector>

#include "sim/base/settings.h"
#include "sim/motion/control/trajectory.h"

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
  static constexpr AboutSettings kAbout{"TimePathOptions", "How a path is timed."};
  double sample_time = 0.02;
};

template <SettingsOf<TimePathOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [sample_time] = options;
  visit("sample_time", sample_time, kTimeAbove0, "s", "Longest time between two samples.");
}

// A motion at rest at both ends. Time starts at 0 and increases.
struct TimedPath {
  std::vector<double> times;                   // s
  std::vector<std::vector<double>> positions;  // one row a sample, one number a joint [rad or m]
  std::vector<std::vector<double>> velocities;
};

// The motion through `waypoints` (at least one, each with one number a joint): the fastest within
// the limits, smoothed so that its acceleration is continuous (smooth_steps.h), which takes two
// more steps from stop to stop.
//
// Every sample lies on the path; the last is the last waypoint, to the bit. Samples are evenly
// spaced from stop to stop. On the cubics between them velocities and accelerations are continuous,
// and within the limits everywhere.
//
// corners: the trapezoidal (or triangular) speed profile on each line, smoothed. The cubics between
// samples stay on the line. smooth: speeds by reachability analysis (path_speed.h) along a cubic
// spline (path_spline.h). Waypoints closer to the one before than 1e-9 of the path's length are
// left out. The cubics between two samples stray from the curve by microradians (3e-5 rad was
// measured at 20 ms and 1 to 3 rad/s).
//
// A path whose waypoints are all equal gives a single sample. A motion from stop to stop takes at
// least a microsecond.
// Throws InputError when waypoints are missing, ragged or not finite, a joint that moves has no
// limits, or they are so small that the motion would take ten million samples.
TimedPath time_path(const std::vector<std::vector<double>>& waypoints, PathKind kind,
                    const JointLimits& limits, const TimePathOptions& options = {});

// The motion along the straight lines between waypoints that rounds off their corners instead of
// stopping there: `blends` has a number from 0 to 1 for each waypoint but the first and the last.
// 0: the motion stops at that waypoint; else the curve leaves its line, and joins the next one, at
// this part of half the shorter line's length from the corner, where a joint counts in units of its
// velocity limit. It is a cubic B-spline with the lines as control polygon, which stays in the
// triangle that the corner makes with the two places, and is timed as a smooth path is. Throws
// InputError like time_path, and for blends that are none.
TimedPath time_blended(const std::vector<std::vector<double>>& waypoints,
                       const std::vector<double>& blends, const JointLimits& limits,
                       const TimePathOptions& options = {});

// Shortest duration of a motion from stop to stop before it is smoothed; a faster one is slowed
// down to it [s]. Then the times of its samples still differ where they are written in nanoseconds,
// and differences of velocities over time are not just rounding.
inline constexpr double kShortestMotion = 1e-6;

// The smallest number of equal steps of `duration`, at least 16, none of them longer than
// `sample_time`; all motions are divided by it. Throws InputError for more than ten million.
int step_count(double duration, double sample_time);

// Appends `path` to `trajectory` as a new segment with the name `segment`. Its times are shifted to
// start at the trajectory's last sample, and the sample where the two meet is kept once. A
// trajectory that has joints but no samples takes the path as it is. Throws InputError when the
// path does not start where the trajectory ends (within 1e-9 rad or m) or has another number of
// joints.
void append(Trajectory& trajectory, const std::string& segment, const TimedPath& path);

}  // namespace prehend
