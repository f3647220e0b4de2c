// A curve of joint space that is run through without a stop.
#pragma once

#include <vector>

#include "sim/motion/control/path_spline.h"
#include "sim/motion/control/time_path.h"

namespace prehend {

// The curve's parameter s is the length along the chords of its waypoints, each joint measured in
// units of its velocity limit: s is in seconds at full speed, so that joints in radians and in
// metres can be mixed.
struct JointCurve {
  std::vector<std::size_t> moving;  // joints that move; `curve` has these only
  std::vector<double> start, end;   // positions of all joints
  PathSpline curve;                 // from the start on: its first point is 0
};

// The cubic spline through waypoints, of which at least two are different. Those closer to the one
// before than 1e-9 of the path's length are left out.
JointCurve curve_through(const std::vector<std::vector<double>>& waypoints,
                         const JointLimits& limits);

// Straight lines between waypoints, all different from their neighbours, with each corner between
// two lines rounded off. One number a corner says how much (0 < blend <= 1): the curve leaves its
// line, and joins the next one, at this part of half the shorter line's length before and after the
// corner. In between it is the uniform cubic B-spline that has the lines as its control polygon:
// two cubics, with a continuous second derivative where they meet each other and the lines. It
// passes the corner at a third of the distance from there to the chord that cuts it off.
JointCurve blended_curve(const std::vector<std::vector<double>>& waypoints,
                         const std::vector<double>& blends, const JointLimits& limits);

}  // namespace prehend
