// One closing of the hand and what it comes to.
#pragma once

#include "sim/trial/close_hand.h"
#include "sim/trial/trial.h"

namespace prehend {

// Closes the hand from `start`, lets coupled fingers center it, and judges what touches: sets all
// of the trial but its travel and back-offs. A hand that centering would push into something is
// hand_blocked. Throws Cancelled.
void grasp_at(const CompiledScene& scene, const ClosingStart& start, const TrialOptions& options,
              Trial& trial, const RunContext& context = {});

// The link that overlaps the object (then `obstacle` is -1) or an obstacle where the hand stands,
// -1 for none.
int colliding_link(const CompiledScene& scene, const Pose& X_OH, const std::vector<double>& joints,
                   int& obstacle);

}  // namespace prehend
