// PD control as robot files state it: gains and largest efforts of the degrees of freedom, and the
// postures that they are to hold.
#pragma once

#include <string>

#include "sim/motion/control/joint_controllers.h"

namespace prehend {

// The gains that the robot states (DegreeOfFreedom::stiffness, damping). A degree of freedom that
// states no stiffness gets the one with which it settles at the frequency [Hz], for the inertia
// that it moves in the robot's posture with the others held still; one that states no damping, the
// critical one for its stiffness and that inertia. Throws InputError for a frequency that is not
// above 0.
PdGains stated_gains(const WorldRobot& robot, double frequency = 3.0);

// A posture that the robot's file names: a preshape of a hand or, for "", the initial values of the
// degrees of freedom [rad or m]. Throws InputError for a name that is not there.
Eigen::VectorXd set_points(const Robot& robot, const std::string& preshape = "");

// Drives that hold the degrees of freedom at the values (a number for each) with these gains, up to
// the largest effort of each (RobotModel::effort). Unlike a sampled pd_controller they are stable
// at any gain. Throws InputError for negative gains and another number of gains or values than the
// robot has degrees of freedom.
std::vector<Drive> pd_drives(const RobotModel& model, const PdGains& gains,
                             const Eigen::VectorXd& values);

}  // namespace prehend
