// What the joints of a robot add to a step: drives, clutches, friction and limits, each as a
// condition with one row.
#pragma once

#include <vector>

#include "sim/motion/contact_problem.h"
#include "sim/motion/world.h"

namespace prehend {

// A condition of a joint, and its place in WorldRobot::joint_impulses.
struct JointCondition {
  ContactCondition condition;
  std::size_t place = 0;
};

// The conditions of a step of `time`, on velocities that begin at `first`. Limits that are too far
// to be reached in the step are left out.
std::vector<JointCondition> joint_conditions(const WorldRobot& robot, int first, double time);

// Where the gears of the robot's clutches stand after a step, which began with `before`: they
// follow their joints as these close, and where the drive opens or more than they bear pushes them
// back.
std::vector<double> gear_stops(const WorldRobot& before, const WorldRobot& after);

// How many places joint_impulses has.
std::size_t joint_places(const WorldRobot& robot);

}  // namespace prehend
