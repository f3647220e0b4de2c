// A robot that gives way at its wrist like a body on springs.
#pragma once

#include "sim/motion/control/controller.h"

namespace prehend {

// Springs between a frame of the robot and where it should be, the same along all axes.
struct WristImpedance {
  double stiffness = 1000.0;        // >= 0 [N/m]
  double turning_stiffness = 10.0;  // >= 0 [N m/rad]
  // Of the inertia of the arm at its wrist on these springs; 1: it returns without overshoot. >= 0
  double damping_ratio = 1.0;
};

// Holds the frame after a joint at the pose X_WT: gravity is compensated, and efforts at the joints
// amount to the force K (p_target - p) at the frame's origin, the moment K e, where e is the
// rotation vector from the frame to the target, and the damping that fits the arm's inertia there.
// A constant force F on the frame thus moves it by F / K. Motions of a redundant arm that leave the
// frame where it is are neither held nor damped. It is sampled: with steps of h [s] the product of
// h and the highest natural frequency [rad/s] must be well below 1. Sources: Hogan 1985, Impedance
// control; Albu-Schaeffer, Ott, Frese and Hirzinger 2003 (damping by joint diagonalisation). Throws
// InputError for a joint that the robot does not have and for negative numbers.
Controller wrist_impedance(const RobotModel& model, int joint, const Pose& X_WT,
                           const WristImpedance& impedance = {});

// The Jacobian of the frame after a joint: its angular and linear velocity (of the frame's origin)
// in world axes, for unit rates of the robot's coordinates. Six rows.
Eigen::MatrixXd frame_jacobian(const WorldRobot& robot, int joint);

}  // namespace prehend
