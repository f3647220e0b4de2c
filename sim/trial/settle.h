// Settling: an object turns between two fingers whose forces do not act along one line, until it is
// held.
#pragma once

#include "sim/trial/grasp_at.h"
#include "sim/trial/trial.h"
#include "sim/trial/turning_room.h"

namespace prehend {

// Buffers of settle, to allocate less; one for each thread.
struct SettleWorkspace {
  ClosingStart start;
  HandTurn turn;
  TurningRoom room;
  Trial now;
  Trial next;
};

// Continues a trial whose outcome is not_force_closure, for a hand with two self-centering fingers
// that both touch. Their forces are then a couple that friction does not resist, so the object
// turns in the hand and the fingers close further. The simulation is quasi-static: it turns the
// hand about the object (the same relative motion) in steps of options.settle.angle, at most
// options.settle.steps of them, and closes the fingers after each. A step counts only if the
// fingers come closer together or the grasp becomes stable; otherwise the angle is halved. A trial
// that does not become stable in this way is left as it was, as are other hands and outcomes.
//
// Among obstacles, the turn must leave both the object and the hand clear of them (TurningRoom): a
// floor far below has no effect, while a table that carries the object or a wall close to it
// prevents the turn.
//
// In scenes with an arm nothing settles. The arm holds the hand still, so the object would have to
// leave its pose in the world, to which the arm's postures and path refer.
//
// Throws Cancelled.
void settle(const CompiledScene& scene, const TrialOptions& options, SettleWorkspace& workspace,
            GraspWorkspace& grasping, Trial& trial, const RunContext& context = {});

}  // namespace prehend
