// The motion of a hand's base during a phase of a protocol.
#pragma once

#include "sim/manipulation/protocol.h"

namespace prehend {

// X_WH at a time since the phase began [s], for a hand that was at X_WH_start. `height`: that of a
// lift [m]; `axis_W`: of a swing or turn. Motions of a lift begin and end at rest, with continuous
// acceleration; swings, turns and circles begin with a quarter of a period in which they grow.
Pose base_pose(const ProtocolPhase& phase, const Pose& X_WH_start, double height,
               const Vector3& axis_W, double time);

}  // namespace prehend
