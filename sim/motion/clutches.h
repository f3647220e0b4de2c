// What the drives of a robot bear, and its clutches.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "sim/robot/robot.h"

namespace prehend {

// A clutch, or what acts like one, between a degree of freedom and some of its joints (all of one
// finger, or a single joint): they may slip against their drive where the clutch bears no more.
struct Clutch {
  int dof = 0;
  std::vector<int> joints;
  double effort = 0.0;  // up to which it holds, in units of the degree of freedom [N m or N]
  // Direction of the joints that close (1 or -1) where a gear behind the clutch keeps them from
  // being pushed back unless their drive opens, as the worm gears of breakaway fingers do; else 0.
  double locks = 0.0;
  // What the gear bears besides the clutch, of the first joint, and how it gives way: without that,
  // gear and contact could press on each other with any force [N m or N, N m/rad or N/m].
  double gear_effort = 0.0;
  double gear_stiffness = 0.0;
  // No clutch but a linkage that closes further when its joint is stopped (gives_way): in units of
  // the degree of freedom, the direction in which it closes (1 or -1), in which a stop keeps its
  // joint from going ahead; else 0.
  double stays_behind = 0.0;
};

// By how much each joint moves in a unit of the clutch's slip [-, or rad/m]: the joints of the
// clutch by their ratios, and those beyond whose drives pass them (Joint::across) back.
Eigen::VectorXd joints_of_slip(const Robot& robot, const Clutch& clutch);

// The largest effort of each degree of freedom: what its joints may bear at most, each through its
// ratio; 0 where none of them says [N m or N].
Eigen::VectorXd stated_efforts(const Robot& robot);

// The clutches of a robot whose degrees of freedom have these efforts, finger after finger. What
// the robot does not say is assumed: breakaway clutches bear a fifth of their drive's effort, those
// of fingers that share a drive share it evenly, and with the gear behind its clutch a finger holds
// a third more than its drive presses.
std::vector<Clutch> clutches_of(const Robot& robot, const Eigen::VectorXd& efforts);

}  // namespace prehend
