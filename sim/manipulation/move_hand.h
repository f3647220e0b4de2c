// Moves the base of a world's hand to a pose within a step: directly, or by the arm that carries
// it.
#pragma once

#include "sim/motion/dynamic_grasp/scene_world.h"
#include "sim/robot/inverse_kinematics.h"

namespace prehend {

// PD controllers that hold the degrees of freedom of a robot outside its hand where they are, with
// the gains that its file states (stated_gains), up to their largest efforts.
std::vector<Drive> arm_drives(const WorldRobot& robot, const WorldHand& hand);

class HandMover {
 public:
  // The world as it is; an arm has drives by arm_drives.
  HandMover(const World& world, const WorldHand& hand);

  // Where the hand's base should be at the end of the next step [s]. A free base gets the
  // velocities that lead there; the controllers of an arm get the set points of the posture nearest
  // to their last ones. False where the arm has no such posture: then nothing is changed.
  bool move(const Pose& X_WH, double step, World& world);

  // The base stands still, or is held at the last set points.
  void stop(World& world) const;

 private:
  WorldHand hand_;
  Pose X_WH_;          // the last
  DofValues posture_;  // set points of all degrees of freedom
};

}  // namespace prehend
