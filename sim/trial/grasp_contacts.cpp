#include "sim/trial/grasp_contacts.h"

#include "sim/scene/compiled_scene.h"
#include "sim/trial/cup_contacts.h"
#include "sim/trial/grasp_contacts_workspace.h"
#include "sim/trial/pad_contacts.h"
#include "sim/trial/trial_options.h"

namespace prehend {

void grasp_contacts(const CompiledScene& scene, const Pose& X_OH, const std::vector<double>& joints,
                    const TrialOptions& options, GraspContactsWorkspace& workspace,
                    std::vector<GraspContact>& contacts) {
  if (!scene.scene.hand.hand->cups.empty()) {
    contacts = cup_contacts(scene, X_OH, joints);
    return;
  }
  const ProximityMesh& object = scene.object().mesh;
  robot_poses(scene.scene.hand, joints, workspace.poses);
  contacts.clear();
  for (std::size_t l = 0; l < scene.links.size(); ++l) {
    const CompiledLink& link = scene.links[l];
    const Pose X_OL = X_OH * workspace.poses.X_BL[l];
    find_contacts(object, link.mesh, X_OL, options.contact, workspace.regions, workspace.touching);
    for (const SurfaceContact& c : workspace.touching) {
      contacts.push_back({link_id(l), {c.position, c.normal, link.friction}, c.gap});
    }
    // A soft link that touches has its rigid contacts, which lie within the contact threshold, and
    // in addition those of the patches on which it bears.
    if (options.contacts == ContactKind::hard || workspace.touching.empty()) continue;
    if (options.contacts == ContactKind::fem && link.pad) {
      add_pad_contacts(scene, X_OH, l, options.pads, workspace, contacts);
      continue;
    }
    if (link.compliant_depth <= 0.0) continue;
    soft_patches(object, link.mesh, X_OL, link.compliant_depth, workspace.soft, workspace.patches);
    for (const SoftPatch& patch : workspace.patches) {
      contacts.push_back(
          {link_id(l),
           {patch.position, patch.normal, link.friction, ContactModel::soft_finger, patch.torsion},
           patch.gap});
    }
  }
}

std::vector<GraspContact> grasp_contacts(const CompiledScene& scene, const Pose& X_OH,
                                         const std::vector<double>& joints,
                                         const TrialOptions& options) {
  GraspContactsWorkspace workspace;
  std::vector<GraspContact> contacts;
  grasp_contacts(scene, X_OH, joints, options, workspace, contacts);
  return contacts;
}

void contacts_of(const std::vector<GraspContact>& contacts, std::vector<Contact>& points) {
  points.clear();
  points.reserve(contacts.size());
  for (const GraspContact& contact : contacts) points.push_back(contact.point);
}

std::vector<Contact> contacts_of(const std::vector<GraspContact>& contacts) {
  std::vector<Contact> points;
  contacts_of(contacts, points);
  return points;
}

}  // namespace prehend
