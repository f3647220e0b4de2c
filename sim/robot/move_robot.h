// Moving one robot of a platform by those that carry it.
#pragma once

#include <optional>

#include "sim/robot/inverse_kinematics.h"
#include "sim/robot/platform.h"

namespace prehend {

// Degrees of freedom that bring the base of robot `part` to `X_BR` in the platform's base frame:
// the nearest to `now` that the inverse kinematics of the robots before it finds. All robots on top
// of it move along; nothing else does. Nothing where no posture inside the limits does it, and for
// a robot that stands on no joint.
std::optional<DofValues> move_robot(const AssembledPlatform& platform, int part, const Pose& X_BR,
                                    const DofValues& now, const IkOptions& options = {});

}  // namespace prehend
