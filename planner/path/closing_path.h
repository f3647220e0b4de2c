// The motion of a hand that closes.
#pragma once

#include <vector>

#include "sim/reach/motion_check.h"
#include "sim/robot/robot.h"

namespace prehend {

struct ClosingPath {
  JointPath postures;         // of the hand's joints: the first, and one for each stop of a joint
  std::vector<double> times;  // of each, from 0 [s]
};

// Each joint moves from `from` at its closing rate until it is where it ends, at `to`.
ClosingPath closing_path(const Robot& hand, const std::vector<double>& from,
                         const std::vector<double>& to);

}  // namespace prehend
