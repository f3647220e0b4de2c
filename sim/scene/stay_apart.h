// Which bodies of a robot can never meet.
#pragma once

#include "sim/scene/compiled_arm.h"

namespace prehend {

// True when it is proven that the bodies of the pair keep a gap in every posture inside the limits:
// no point moves farther than its reach times the turn, so one gap speaks for a box of postures
// around it, and boxes are halved until all are spoken for. False when they meet somewhere, or the
// proof gets long: the pair is then tested as it moves.
bool stay_apart(const CompiledArm& arm, const ArmPair& pair);

}  // namespace prehend
