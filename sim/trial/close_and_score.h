// Closes the hand once and judges the grasp that results.
#pragma once

#include <vector>

#include "sim/quality/epsilon_workspace.h"
#include "sim/quality/wrench.h"
#include "sim/trial/close_hand.h"
#include "sim/trial/grasp_contacts.h"
#include "sim/trial/hand_collision.h"
#include "sim/trial/trial.h"

namespace prehend {

// Buffers of close_and_score, to allocate less; one for each thread.
struct GraspWorkspace {
  ClosingWorkspace closing;
  ClosedHand closed;
  HandCollisionWorkspace collision;
  GraspContactsWorkspace contacts;
  std::vector<Contact> points;
  WrenchWorkspace wrenches;
  EpsilonWorkspace epsilon;
};

// Closes the hand from `start`, centres it with self-centering fingers (center_hand), finds the
// contacts and computes their quality. Sets the outcome, X_OH, dofs, joints, contacts, epsilon and
// `blocked` of the trial; what belongs to its approach and to the arm stays. A hand that centring
// pushes into the object or an obstacle is hand_blocked. Throws Cancelled.
void close_and_score(const CompiledScene& scene, const ClosingStart& start,
                     const TrialOptions& options, GraspWorkspace& workspace, Trial& trial,
                     const RunContext& context = {});

// Finds the contacts of the hand as the trial has it, and sets contacts, epsilon and outcome:
// no_contact, not_force_closure or stable.
void score_contacts(const CompiledScene& scene, const TrialOptions& options,
                    GraspWorkspace& workspace, Trial& trial);

}  // namespace prehend
