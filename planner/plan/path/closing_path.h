// The motion of a hand that closes.
#pragma once

#include <vector>

#include "sim/robot/robot.h"
#include "sim/scene/reach/motion_check.h"

namespace prehend {

struct ClosingPath {
  JointPath postures;         // of the hand's joints: the first, and one for each stop of a joint
  std::vector<double> times;  // of each, from 0 [s]
};

// Each joint of `hand` moves from `from` to `to` (one value a joint [rad or m]) at its closing
// velocity and then waits there; the path has a posture at every time at which a joint arrives,
// none of them within 1 ms of each other: joints that arrive so close together do so with the last.
// Joints that do not close, or end on the opening side, take one second.
ClosingPath closing_path(const Robot& hand, const std::vector<double>& from,
                         const std::vector<double>& to);

}  // namespace prehend
