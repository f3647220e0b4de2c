// Motions that controllers follow.
#pragma once

#include "sim/motion/control/controller.h"
#include "sim/motion/control/trajectory.h"

namespace prehend {

// The motion of a robot along a trajectory, whose names are those of degrees of freedom; those it
// does not name stay at `rest` (a number for each). Before its first sample and after its last the
// motion stands still there. Throws InputError for a name that the robot does not have, and for a
// trajectory without samples.
JointMotion motion_along(const Trajectory& trajectory, const Robot& robot,
                         const Eigen::VectorXd& rest);

}  // namespace prehend
