// Time-optimal speed along a given curve under joint velocity and acceleration limits.
#pragma once

#include <vector>

#include "sim/motion/control/time_path.h"

namespace prehend {

// A grid point of a curve q(s): the parameter, and the first and second derivative by s, with one
// number a joint.
struct PathStation {
  double s = 0.0;
  std::vector<double> dq, ddq;
  // In (0, 1]: how much slower than the limits allow time passes here. Velocities are limited to
  // this part of their limits, accelerations to its square.
  double pace = 1.0;
};

// The squared speed (ds/dt)^2 at each station, 0 at the first and the last, of the fastest run from
// rest to rest. Between two stations d2s/dt2 is constant. At every station
//   |q' ds/dt| <= pace velocity and |q' d2s/dt2 + q'' (ds/dt)^2| <= pace^2 acceleration
// hold for every joint, the latter with d2s/dt2 of the interval before the station and of the one
// after it. (ds/dt)^2 is at most 1e4.
//
// A backward pass finds, for each station, the largest squared speed from which the end can still
// be reached; a forward pass takes the largest of these that it can reach. Source: Pham and Pham
// 2018, A New Approach to Time-Optimal Path Parameterization Based on Reachability Analysis,
// sections III and IV, with the interpolation scheme of section V.
//
// `stations`: at least two, s increasing. All limits > 0.
std::vector<double> fastest_squared_speeds(const std::vector<PathStation>& stations,
                                           const JointLimits& limits);

}  // namespace prehend
