#include "sim/trial/close_and_score.h"

#include "sim/trial/self_centering.h"

namespace prehend {

// Closing proves that the hand touches without penetrating. Centring then moves the hand as a
// whole, without a proof, so that collisions have to be looked for; without centring there can be
// none.
void close_and_score(const CompiledScene& scene, const ClosingStart& start,
                     const TrialOptions& options, GraspWorkspace& workspace, Trial& trial,
                     const RunContext& context) {
  ClosedHand& closed = workspace.closed;
  close_hand(scene, start, options, workspace.closing, closed, context);
  trial.X_OH = start.X_OH;
  trial.blocked.reset();
  if (center_hand(scene, trial.X_OH, closed)) {
    trial.blocked = hand_collision(scene, trial.X_OH, closed.joints, workspace.collision);
  }
  trial.pushed = start.X_OH.translation() - trial.X_OH.translation();
  trial.dofs = closed.dofs;
  trial.joints = closed.joints;
  context.cancellation.check();
  if (!trial.blocked) {
    score_contacts(scene, options, workspace.scoring, trial);
    return;
  }
  trial.epsilon = {};
  trial.contacts.clear();
  trial.outcome = Outcome::hand_blocked;
}

}  // namespace prehend
