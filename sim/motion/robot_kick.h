// What the forces on a robot do to its velocities, but for those of contacts and of the conditions
// of its joints (joint_conditions.h).
#pragma once

#include <Eigen/Core>

#include "sim/motion/world.h"

namespace prehend {

// mass * (rates of the coordinates) = momentum.
struct RobotKick {
  Eigen::MatrixXd mass = {};  // positive definite
  Eigen::VectorXd momentum = {};
};

// The rates after weight, efforts, springs and friction acted for a time `kick`, as they are where
// the robot stands and moves now, but for two: springs act as they are once it has moved on with
// the new rates for that time, so that no stiffness makes a step unstable, and viscous friction
// acts on the new rates, so that it never turns a motion round. `step`: in which the velocity of
// the base changed [s].
RobotKick kicked(const WorldRobot& robot, const Vector3& gravity_W, double step, double kick);

// The rates at the end of a step in which nothing touched the robot: what acts where it has arrived
// acts for the second half of the step, as what acted before acted for the first (velocity Verlet),
// and springs as they are in the middle (Hairer, Lubich and Wanner 2006, Geometric Numerical
// Integration, sections I.1.4 and II.1.2). The robot's rates are those with which it moved.
Eigen::VectorXd rates_after(const WorldRobot& robot, const Vector3& gravity_W, double step);

}  // namespace prehend
