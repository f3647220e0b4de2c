// A timed motion as straight lines, for a proof that it is free of collision.
#pragma once

#include <vector>

#include "sim/motion/control/time_path.h"

namespace prehend {

// Straight lines between waypoints, and how far beside them each joint may be [rad or m]: what
// first_blocked takes.
struct MotionLines {
  std::vector<std::vector<double>> lines;
  std::vector<double> sway;
};

// The motion on the cubics from sample `first` to sample `last`. Each joint is at any time within
// `sway` of its place at some point of the lines, all joints at the same point.
MotionLines motion_lines(const TimedPath& path, std::size_t first, std::size_t last);

}  // namespace prehend
