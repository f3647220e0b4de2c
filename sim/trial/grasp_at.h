// Closes the hand once and judges the grasp that results.
#pragma once

#include "sim/trial/close_hand.h"
#include "sim/trial/trial.h"

namespace prehend {

// Closes the hand from `start`, centres it with self-centering fingers (center_hand), finds the
// contacts and computes their quality. Sets the outcome, X_OH, dofs, joints, contacts, epsilon and
// `blocked` of the trial; what belongs to its approach and to the arm stays. A hand that centring
// pushes into the object or an obstacle is hand_blocked. Throws Cancelled.
void grasp_at(const CompiledScene& scene, const ClosingStart& start, const TrialOptions& options,
              Trial& trial, const RunContext& context = {});

}  // namespace prehend
