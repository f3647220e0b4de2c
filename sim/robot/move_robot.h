// Moving one robot of a platform by those that carry it.
#pragma once

#include <optional>

#include "sim/robot/inverse_kinematics.h"
#include "sim/robot/platform.h"

namespace prehend {

// Values of the platform's degrees of freedom that bring the base of robot `part` to `X_BR` in the
// platform's base frame B: of the solutions of solve_all the one nearest to `now`. Only the joints
// that carry the robot move, and with them what else they carry. Nothing where no posture inside
// the limits is found, and for a robot that no joint carries.
std::optional<DofValues> move_robot(const AssembledPlatform& platform, int part, const Pose& X_BR,
                                    const DofValues& now, const IkOptions& options = {});

}  // namespace prehend
