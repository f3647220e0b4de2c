// What drives the joints of a hand in a simulator whose couplings are rigid.
#pragma once

#include <vector>

#include "sim/motion/robot_model.h"
#include "sim/robot/robot.h"

namespace prehend {

// A motor at a joint.
struct HandDrive {
  int joint = 0;
  double effort = 0.0;  // the largest it makes, > 0 [N m or N]
  // The effort with its sign in which the hand closes, 0 where the joint holds its value instead.
  double closing = 0.0;
};

// value - value at the grasp = ratio * (leader - leader at the grasp).
struct HandCoupling {
  int joint = 0;
  int leader = 0;
  double ratio = 1.0;
};

// A joint that follows its leader as a coupling says, but slips where this takes more effort.
struct HandClutch {
  HandCoupling follows;
  double effort = 0.0;  // > 0 [N m or N]
};

struct HandDrives {
  std::vector<HandDrive> drives;        // in the order of joints
  std::vector<HandCoupling> couplings;  // in the order of joints
  std::vector<HandClutch> clutches;     // in the order of joints
};

struct HandDriveOptions {
  // Of a drive whose effort the robot file does not state.
  double force = 20.0;  // prismatic joints [N]
  double torque = 1.0;  // revolute joints [N m]
  // The clutches of degrees of freedom that break away; those without one are as if they had none.
  std::vector<Clutch> clutches = {};
};

// The joints of a degree of freedom move together as they do from the grasp on: all of them where
// their coupling is rigid or self-centering, else those of each finger (joints behind the same
// first joint). Without clutches a joint that stopped before the others keeps its way behind them.
// With them, its degree of freedom drives the first joint that has none. Each other joint whose
// effort is stated has a drive; in a set of joints that move together without one, the first has a
// drive, as strong as another of the same degree of freedom or as the options say.
HandDrives hand_drives(const Robot& hand, const HandDriveOptions& options = {});

}  // namespace prehend
