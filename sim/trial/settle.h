// A free object turns between two fingers that squeeze it off its centre.
#pragma once

#include "sim/trial/trial.h"

namespace prehend {

// Where a hand with two self-centering fingers touches with both but does not hold, its squeeze is
// a couple that the grasp cannot resist: the object turns (here, the hand turns about it, which is
// the same) and the fingers close after it, until they hold or come no closer. Quasi-static, in
// steps of options.settle.angle, at most options.settle.steps of them; the fingers lose width in
// every step. What does not come to hold stays as it was. Leaves other hands and outcomes alone.
//
// Among obstacles it turns only as far as neither the object nor the hand can touch one of them
// (see TurningRoom): a floor far below changes nothing, a table that the object stands on or a wall
// beside it keeps it from turning.
//
// In the hand of an arm nothing turns. The arm holds the hand still, so it would be the object that
// leaves its pose in the world, while the arm's postures, its path and every picture are about the
// object where the scene puts it; and what a carried hand reaches for usually stands on something.
//
// Throws Cancelled.
void settle(const CompiledScene& scene, const TrialOptions& options, Trial& trial,
            const RunContext& context = {});

}  // namespace prehend
