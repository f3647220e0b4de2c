// Drives that hold, close and open the hand of a world.
#pragma once

#include <vector>

#include "sim/motion/dynamic_grasp/closing.h"
#include "sim/motion/dynamic_grasp/scene_world.h"

namespace prehend {

// Drives that hold the hand's degrees of freedom where they are, up to their largest efforts.
// `model`: of the robot that the hand is, or is a part of.
std::vector<Drive> holding_drives(const RobotModel& model, const WorldHand& hand);

// Drives that close every degree of freedom with a closing velocity until it presses with its
// largest effort, and hold the others where they are.
std::vector<Drive> closing_drives(const RobotModel& model, const WorldHand& hand);

// Drives that do what `closing` says next.
std::vector<Drive> closing_drives(const RobotModel& model, const WorldHand& hand,
                                  const Closing& closing);

// Drives that take the hand to a posture (`open`, its degrees of freedom) at its closing
// velocities, and hold it there. `now`: coordinates of the robot.
std::vector<Drive> opening_drives(const RobotModel& model, const WorldHand& hand,
                                  const Eigen::VectorXd& now, const std::vector<double>& open);

// Replaces the drives of the hand by others of this file; those of the arm stay.
void set_hand_drives(const std::vector<Drive>& drives, const WorldHand& hand, WorldRobot& robot);

}  // namespace prehend
