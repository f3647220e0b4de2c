// Controllers of the degrees of freedom of a robot, each by itself or by the robot's equation of
// motion. Source: Siciliano, Sciavicco, Villani and Oriolo 2009, Robotics: Modelling, Planning and
// Control, chapter 8.
#pragma once

#include "sim/motion/control/controller.h"

namespace prehend {

// One number for each degree of freedom, >= 0.
struct PdGains {
  Eigen::VectorXd stiffness;  // N m/rad or N/m
  Eigen::VectorXd damping;    // N m s/rad or N s/m
};

// Throws InputError for negative gains and another number of them than the robot has degrees of
// freedom.
void require_gains(const RobotModel& model, const PdGains& gains);

// The inertia that each degree of freedom moves in the robot's posture, the others held still
// [kg m^2 or kg].
Eigen::VectorXd moved_inertias(const WorldRobot& robot);

// Gains with which each degree of freedom, the others held still, settles without overshoot at the
// frequency [Hz], for the inertia that it moves in the robot's posture. Throws InputError for a
// frequency that is not above 0.
PdGains critically_damped(const WorldRobot& robot, double frequency);

// Feedback by position and velocity:
//
//   effort = stiffness (motion - value) + damping (rate of the motion - rate)
//
// By itself it lags behind what gravity and inertia ask for. It is sampled: at steps of h [s] it is
// stable for damping * h below twice the inertia that is moved; a Drive (world.h) has no such
// limit. Throws InputError for negative gains and another number of them than the robot has degrees
// of freedom.
Controller pd_controller(const RobotModel& model, const PdGains& gains, JointMotion motion);

// The efforts that hold the robot where it is against gravity and the springs of its joints,
// whatever its velocity.
Controller gravity_compensation();

// Feed-forward by recursive Newton-Euler: the efforts that give the robot the accelerations of the
// motion and, where it has left the motion, those of a critically damped return at `frequency` [Hz]
// (computed torque). The motion is differenced over the steps in which the world moves, so that a
// robot on the motion stays on it. Springs of joints are compensated, friction in them is not.
// Throws InputError for a frequency that is not above 0.
Controller computed_torque(JointMotion motion, double frequency);

}  // namespace prehend
