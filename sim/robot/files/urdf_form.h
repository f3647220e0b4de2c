// Robots under the names and in the variables that they have in URDF.
#pragma once

#include "sim/robot/platform.h"

namespace prehend {

// One of the platform's robots. Names of chains, links and joints are ROBOT_NAME where there are
// several, except of joints that the robot's driver has a name for. Every degree of freedom is
// called after one of its joints, whose value it is (ratio 1, offset 0): one that is so already,
// else the first.
Robot urdf_form(const Platform& platform, const MountedRobot& mounted);

}  // namespace prehend
