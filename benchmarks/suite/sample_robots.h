// Poses that robots reach, to ask their inverse kinematics for.
#pragma once

#include <vector>

#include "sim/base/random.h"
#include "sim/robot/inverse_kinematics.h"

namespace prehend::bench {

// Poses of the frame X_JT after `joint`, at random values of the degrees of freedom, always the
// same ones.
std::vector<IkTarget> reachable_targets(const Robot& robot, int joint, const Pose& X_JT, int count);

// The robot as if there were no closed form of its inverse kinematics.
Robot without_closed_form(Robot robot);

}  // namespace prehend::bench
