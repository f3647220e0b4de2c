// One closing of the hand and what it comes to.
#pragma once

#include "sim/trial/close_hand.h"
#include "sim/trial/trial.h"

namespace prehend {

// Closes the hand from `start`, lets self-centering fingers center it, and judges the contacts:
// sets everything of the trial except what belongs to its approach and the arm. A hand that
// centering would push into something is hand_blocked. Throws Cancelled.
void grasp_at(const CompiledScene& scene, const ClosingStart& start, const TrialOptions& options,
              Trial& trial, const RunContext& context = {});

}  // namespace prehend
