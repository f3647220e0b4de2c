// Motion along a smooth curve of joint space, without a stop.
#pragma once

#include <vector>

#include "planner/path/path_spline.h"
#include "planner/path/time_path.h"

namespace prehend {

// The motion that time_path describes for PathKind::smooth. The curve's parameter is the length
// along the chords of the waypoints, each joint measured in units of its velocity limit: seconds at
// full speed, so that radians and metres can be mixed.
class CurveRun {
 public:
  // At least two different waypoints.
  CurveRun(const std::vector<std::vector<double>>& waypoints, const JointLimits& limits);

  // The motion with all its times multiplied by `slower` (>= 1). `sample_time` in s. Throws
  // InputError when it would take too many samples.
  TimedPath sample(double slower, double sample_time) const;

 private:
  void add_sample(TimedPath& path, double s, double speed) const;

  std::vector<std::size_t> moving_;  // joints that move; the curve has these only
  std::vector<double> start_, end_;  // waypoints
  PathSpline curve_;
  std::vector<double> s_, speeds_, times_;  // of the stations, with d2s/dt2 constant between
};

}  // namespace prehend
