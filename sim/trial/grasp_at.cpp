#include "sim/trial/grasp_at.h"

#include "sim/contact/contact_region.h"
#include "sim/contact/soft_patch.h"
#include "sim/trial/hand_collision.h"
#include "sim/trial/self_centering.h"

namespace prehend {
namespace {

// Sets contacts, quality and outcome of a hand that has closed. A lower bound of epsilon above 0
// proves force closure.
void judge(const CompiledScene& scene, const TrialOptions& options, Trial& trial) {
  trial.epsilon = {};
  trial.contacts.clear();
  if (trial.blocked) {
    trial.outcome = Outcome::hand_blocked;
    return;
  }
  trial.contacts = grasp_contacts(scene, trial.X_OH, trial.joints, options);
  if (trial.contacts.empty()) {
    trial.outcome = Outcome::no_contact;
    return;
  }
  trial.epsilon = epsilon_l1(
      contact_wrenches(contacts_of(trial.contacts), scene.wrench_frame, options.cone_edges));
  trial.outcome = trial.epsilon.lower > 0.0 ? Outcome::stable : Outcome::not_force_closure;
}

}  // namespace

// Closing proves that the hand touches without penetrating. Centring then moves the hand as a
// whole, without a proof, so that collisions have to be looked for; without centring there can be
// none.
void grasp_at(const CompiledScene& scene, const ClosingStart& start, const TrialOptions& options,
              Trial& trial, const RunContext& context) {
  ClosedHand closed = close_hand(scene, start, options, context);
  trial.X_OH = start.X_OH;
  trial.blocked.reset();
  if (center_hand(scene, trial.X_OH, closed)) {
    trial.blocked = hand_collision(scene, trial.X_OH, closed.joints);
  }
  trial.dofs = closed.dofs;
  trial.joints = closed.joints;
  context.cancellation.check();
  judge(scene, options, trial);
}

std::vector<GraspContact> grasp_contacts(const CompiledScene& scene, const Pose& X_OH,
                                         const std::vector<double>& joints,
                                         const TrialOptions& options) {
  std::vector<Pose> X_HL;
  link_poses(scene.scene.hand, joints, X_HL);
  ContactWorkspace workspace;
  std::vector<GraspContact> contacts;
  for (std::size_t l = 0; l < scene.links.size(); ++l) {
    const CompiledLink& link = scene.links[l];
    const Pose X_OL = X_OH * X_HL[l];
    const auto touching =
        find_contacts(scene.object().mesh, link.mesh, X_OL, options.contact, workspace);
    for (const SurfaceContact& c : touching) {
      contacts.push_back({link_id(l), {c.position, c.normal, link.friction}, c.gap});
    }
    // A soft link that touches has its rigid contacts, which lie within the contact threshold, and
    // in addition a soft-finger contact for each patch on which it bears.
    if (!options.soft_fingers || link.compliant_depth <= 0.0 || touching.empty()) continue;
    for (const SoftPatch& patch : soft_patches(scene.object().mesh, link.mesh, X_OL,
                                               link.compliant_depth, options.contact, workspace)) {
      contacts.push_back(
          {link_id(l),
           {patch.position, patch.normal, link.friction, ContactModel::soft_finger, patch.torsion},
           patch.gap});
    }
  }
  return contacts;
}

std::vector<Contact> contacts_of(const std::vector<GraspContact>& contacts) {
  std::vector<Contact> points;
  points.reserve(contacts.size());
  for (const GraspContact& contact : contacts) points.push_back(contact.point);
  return points;
}

}  // namespace prehend
