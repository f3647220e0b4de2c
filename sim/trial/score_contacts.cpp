#include "sim/trial/score_contacts.h"

#include <algorithm>

#include "sim/scene/compiled_scene.h"

namespace prehend {

namespace {

bool touches(const std::vector<GraspContact>& contacts, const SurfaceRegions& regions) {
  return std::any_of(contacts.begin(), contacts.end(), [&](const GraspContact& contact) {
    return regions.contain(contact.point.position);
  });
}

bool touches_only(const std::vector<GraspContact>& contacts, const SurfaceRegions& regions) {
  return std::all_of(contacts.begin(), contacts.end(), [&](const GraspContact& contact) {
    return regions.contain(contact.point.position);
  });
}

}  // namespace

void score_contacts(const CompiledScene& scene, const TrialOptions& options,
                    ScoringWorkspace& workspace, Trial& trial) {
  trial.epsilon = {};
  trial.preferred = false;
  grasp_contacts(scene, trial.X_OH, trial.joints, options, workspace.contacts, trial.contacts);
  if (trial.contacts.empty()) {
    trial.outcome = scene.scene.hand.hand->cups.empty() ? Outcome::no_contact : Outcome::no_seal;
    return;
  }
  if (!scene.keep_out.empty() && touches(trial.contacts, scene.keep_out)) {
    trial.outcome = Outcome::keep_out;
    return;
  }
  contacts_of(trial.contacts, workspace.points);
  trial.epsilon = epsilon_l1(contact_wrenches(workspace.points, scene.wrench_frame,
                                              options.cone_edges, workspace.wrenches),
                             {}, workspace.epsilon);
  trial.outcome = trial.epsilon.lower > 0.0 ? Outcome::stable : Outcome::not_force_closure;
  trial.preferred = trial.outcome == Outcome::stable && !scene.preferred.empty() &&
                    touches_only(trial.contacts, scene.preferred);
}

}  // namespace prehend
