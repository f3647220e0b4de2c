// A free object turns between two fingers that squeeze it off its centre.
#pragma once

#include "sim/trial/trial.h"

namespace prehend {

// Where a hand with two self-centering fingers touches with both but does not hold, its squeeze is
// a couple that the grasp cannot resist: the object turns (here, the hand turns about it, which is
// the same) and the fingers close after it, until they hold or come no closer. Quasi-static, in
// steps of options.settle_angle, at most options.settle_steps of them; the fingers lose width in
// every step. What does not come to hold stays as it was. Leaves other hands and outcomes alone,
// and objects among obstacles or in the hand of an arm: what is not free to turn.
// Throws Cancelled.
void settle(const CompiledScene& scene, const TrialOptions& options, Trial& trial,
            const RunContext& context = {});

}  // namespace prehend
