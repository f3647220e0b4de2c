// What drives the joints of a hand in a simulator whose couplings are rigid.
#pragma once

#include <vector>

#include "sim/motion/clutches.h"
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

// The joints of a degree of freedom move together as they do from the grasp on: all of them where
// their coupling is rigid or self-centering, else those of each finger (joints behind the same
// first joint). Without clutches a joint that stopped before the others keeps its way behind them.
// With them, its degree of freedom drives the first joint that has none, and the one that its drive
// passes (Joint::across) as well. Each other joint whose
// effort is stated has a drive; in a set of joints that move together without one, the first has a
// drive, as strong as another of the same degree of freedom, else 20 N or 1 N m. `clutches`: those
// of degrees of freedom that break away; those without one are as if they had none.
HandDrives hand_drives(const Robot& hand, const std::vector<Clutch>& clutches = {});

}  // namespace prehend
