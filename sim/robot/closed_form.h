// Which closed form of inverse kinematics a chain has, found by its axes.
#pragma once

#include "sim/robot/robot.h"

namespace prehend {

// The first of spherical_wrist and ur whose conditions the joints of the chain meet
// (spherical_wrist.h, ur_arm.h), else none.
ClosedForm closed_form_of(const Robot& robot, const Chain& chain);

}  // namespace prehend
