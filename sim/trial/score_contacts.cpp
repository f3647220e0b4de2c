#include "sim/trial/score_contacts.h"

#include "sim/scene/compiled_scene.h"

namespace prehend {

void score_contacts(const CompiledScene& scene, const TrialOptions& options,
                    ScoringWorkspace& workspace, Trial& trial) {
  trial.epsilon = {};
  grasp_contacts(scene, trial.X_OH, trial.joints, options, workspace.contacts, trial.contacts);
  if (trial.contacts.empty()) {
    trial.outcome = Outcome::no_contact;
    return;
  }
  contacts_of(trial.contacts, workspace.points);
  trial.epsilon = epsilon_l1(contact_wrenches(workspace.points, scene.wrench_frame,
                                              options.cone_edges, workspace.wrenches),
                             {}, workspace.epsilon);
  trial.outcome = trial.epsilon.lower > 0.0 ? Outcome::stable : Outcome::not_force_closure;
}

}  // namespace prehend
