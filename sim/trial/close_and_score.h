// Closes the hand once and scores the grasp that results.
#pragma once

#include "sim/trial/close_hand.h"
#include "sim/trial/hand_collision.h"
#include "sim/trial/score_contacts.h"
#include "sim/trial/trial.h"
#include "sim/trial/trial_options.h"

namespace prehend {

// Buffers of close_and_score, to allocate less; one for each thread.
struct GraspWorkspace {
  ClosingWorkspace closing;
  ClosedHand closed;
  HandCollisionWorkspace collision;
  ScoringWorkspace scoring;
};

// Closes the hand from `start`, centres it with self-centering fingers (center_hand), finds the
// contacts and computes their quality. Sets the outcome, X_OH, dofs, joints, contacts, epsilon and
// `blocked` of the trial; what belongs to its approach and to the arm stays. A hand that centring
// pushes into the object or an obstacle is hand_blocked. Throws Cancelled.
void close_and_score(const CompiledScene& scene, const ClosingStart& start,
                     const TrialOptions& options, GraspWorkspace& workspace, Trial& trial,
                     const RunContext& context = {});

}  // namespace prehend
