// Motion along a smooth curve of joint space, without a stop.
#pragma once

#include <vector>

#include "planner/path/path_spline.h"
#include "planner/path/time_path.h"

namespace prehend {

// The motion that time_path describes for PathKind::smooth: a cubic spline through the waypoints
// with its time-optimal speed. The curve's parameter s is the length along the chords of the
// waypoints, each joint measured in units of its velocity limit: s is in seconds at full speed, so
// that joints in radians and in metres can be mixed.
class CurveRun {
 public:
  // At least two different waypoints.
  CurveRun(const std::vector<std::vector<double>>& waypoints, const JointLimits& limits);

  // The motion with all its times multiplied by `slower` (>= 1). `sample_time` in s. Throws
  // InputError when it would take too many samples.
  TimedPath sample(double slower, double sample_time) const;

 private:
  // Appends position and velocity at s for ds/dt = `speed`; the time is the caller's to append.
  void add_sample(TimedPath& path, double s, double speed) const;

  std::vector<std::size_t> moving_;  // joints that move; the curve has these only
  std::vector<double> start_, end_;  // waypoints
  PathSpline curve_;
  // Parameter, ds/dt and time [s] of each station; d2s/dt2 is constant between two of them.
  std::vector<double> s_, speeds_, times_;
};

}  // namespace prehend
