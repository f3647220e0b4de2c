// Finds pairs of bodies that cannot collide in any posture of the arm and so need no check.
#pragma once

#include "sim/scene/compiled_arm.h"

namespace prehend {

// True when it is proven that the bodies of the pair keep a gap in every posture inside the joint
// limits. The proof: no point moves farther than its reach times the joint's motion, so a gap in
// one posture that is larger than that covers a whole box of postures around it; the box of all
// postures is halved until every part is covered. False when the bodies collide in some posture, or
// the proof takes too many gap queries: the pair is then checked during motions.
bool never_collide(const CompiledArm& arm, const ArmPair& pair);

}  // namespace prehend
