// Controllers: functions from the state of a robot to the efforts of its drives.
#pragma once

#include <functional>
#include <vector>

#include "sim/motion/world.h"

namespace prehend {

// What a controller knows when it is asked.
struct ControlState {
  double time;              // since the run began [s]
  double step;              // for how long its efforts will act, at most [s]
  const WorldRobot& robot;  // where it is and how fast it moves
  Vector3 gravity_W;        // [m/s^2]
};

// The effort of each degree of freedom [N m or N]. It is asked at the beginning of each step, and
// its efforts act during the whole step, as those of a sampled controller do.
using Controller = std::function<Eigen::VectorXd(const ControlState&)>;

// The values that the degrees of freedom should have at a time [rad or m]. Controllers also ask for
// times before 0 and after the end of a motion, where it stands still.
using JointMotion = std::function<Eigen::VectorXd(double time)>;

// A controller whose efforts are the sum of those of others, as feed-forward and feedback are.
Controller sum_of(std::vector<Controller> controllers);

}  // namespace prehend
