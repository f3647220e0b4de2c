// The score of a closed grasp: the contacts of its hand, and epsilon of their wrenches.
#pragma once

#include <vector>

#include "sim/quality/epsilon_workspace.h"
#include "sim/quality/wrench.h"
#include "sim/quality/wrench_workspace.h"
#include "sim/trial/grasp_contacts.h"
#include "sim/trial/grasp_contacts_workspace.h"
#include "sim/trial/trial.h"
#include "sim/trial/trial_options.h"

namespace prehend {

struct CompiledScene;

// Buffers of score_contacts, to allocate less; one for each thread.
struct ScoringWorkspace {
  GraspContactsWorkspace contacts;
  std::vector<Contact> points;
  WrenchWorkspace wrenches;
  EpsilonWorkspace epsilon;
};

// Finds the contacts of the hand as the trial has it, and sets contacts, epsilon in the L1 wrench
// space, outcome and `preferred`: no_contact (with suction cups no_seal), keep_out where a contact
// is in such a region, not_force_closure or stable. A lower bound of epsilon above 0 proves force
// closure.
void score_contacts(const CompiledScene& scene, const TrialOptions& options,
                    ScoringWorkspace& workspace, Trial& trial);

}  // namespace prehend
