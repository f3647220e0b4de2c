// Settling: an object turns and slides between two fingers whose forces do not balance, until it is
// held.
#pragma once

#include "sim/trial/clearance_budget.h"
#include "sim/trial/close_and_score.h"
#include "sim/trial/trial.h"

namespace prehend {

// Buffers of settle, to allocate less; one for each thread.
struct SettleWorkspace {
  ClosingStart start;
  HandTurn turn;
  ClearanceBudget room;
  Trial now;
  Trial next;
};

// Continues a trial whose outcome is not_force_closure, for a hand with two self-centering fingers
// that both touch. Their forces then do not balance, so the object turns and slides in the hand and
// the fingers close further. The simulation is quasi-static: it moves the hand relative to the
// object, the opposite way of the object (`squeezed`), in at most options.settle.steps steps, and
// closes the fingers after each. A step counts only if the fingers come closer together or the
// grasp becomes stable; otherwise the steps become half as large. A trial that does not become
// stable in this way is left as it was, as are other hands and outcomes.
//
// Among obstacles, the motion must leave both the object and the hand clear of them
// (ClearanceBudget): a floor far below has no effect, while a table that carries the object or a
// wall close to it prevents the motion.
//
// In scenes with an arm nothing settles. The arm holds the hand still, so the object would have to
// leave its pose in the world, to which the arm's postures and path refer.
//
// Throws Cancelled.
void settle(const CompiledScene& scene, const TrialOptions& options, SettleWorkspace& workspace,
            GraspWorkspace& grasping, Trial& trial, const RunContext& context = {});

}  // namespace prehend
