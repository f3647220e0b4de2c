// The springs of joints (Joint::spring).
#pragma once

#include <Eigen/Core>

#include "sim/motion/robot_model.h"

namespace prehend {

// What the springs do to the joints at the values q, stiffness * (rest - q) [N m or N].
Eigen::VectorXd spring_efforts(const Robot& robot, const Eigen::VectorXd& q);

// Their potential energy there [J].
double spring_energy(const Robot& robot, const Eigen::VectorXd& q);

// Adds the springs to a step of `time`, which solves mass * rate = momentum for the rates of the
// coordinates. They act as they are at its end, so that no stiffness makes a step unstable:
// q + time * (joints_of * rate) instead of q.
void add_springs(const RobotModel& model, const Eigen::VectorXd& q, double time,
                 Eigen::MatrixXd& mass, Eigen::VectorXd& momentum);

}  // namespace prehend
