#include "sim/trial/grasp_contacts.h"

#include <algorithm>
#include <span>

#include "sim/scene/compiled_scene.h"
#include "sim/trial/cup_contacts.h"
#include "sim/trial/grasp_contacts_workspace.h"
#include "sim/trial/pad_contacts.h"
#include "sim/trial/trial_options.h"

namespace prehend {
namespace {

// A contact point with friction.
Contact rubbing(const SurfaceContact& at, double friction, const std::optional<double>& deviation) {
  Contact contact{at.position, at.normal, friction};
  contact.friction_deviation = deviation;
  return contact;
}

Contact rubbing(const SoftPatch& patch, double friction, const std::optional<double>& deviation) {
  Contact contact{patch.position, patch.normal, friction, ContactModel::soft_finger, patch.torsion};
  contact.friction_deviation = deviation;
  return contact;
}

// The contacts of a link where it or the object has parts of several materials. Each point has the
// materials that touch there. Points of different materials form contact regions of their own,
// which transmit what all distributions of force over the whole region do.
class PartedContacts {
 public:
  PartedContacts(const CompiledScene& scene, LinkId link, const Pose& X_OL,
                 GraspContactsWorkspace& workspace)
      : scene_(scene),
        link_(scene.links[index(link)]),
        id_(link),
        X_OL_(X_OL),
        X_LO_(X_OL.inverse()),
        workspace_(workspace) {}

  // Points in contact, reduced to regions; whether there are any.
  bool add_points(const ContactOptions& options, std::vector<GraspContact>& contacts) {
    std::vector<SurfaceContact>& points = workspace_.all_touching;
    find_contact_points(scene_.object().mesh, link_.mesh, X_OL_, options,
                        workspace_.regions.contacts, points);
    std::vector<TouchingRegions>& materials = workspace_.materials;
    materials.clear();
    for (const SurfaceContact& point : points) materials.push_back(regions_at(point.position));
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto first = std::find(materials.begin(), materials.end(), materials[i]);
      if (first != materials.begin() + static_cast<std::ptrdiff_t>(i)) continue;
      std::vector<SurfaceContact>& alike = workspace_.touching;
      alike.clear();
      for (std::size_t k = i; k < points.size(); ++k) {
        if (materials[k] == materials[i]) alike.push_back(points[k]);
      }
      for (const SurfaceContact& c : contact_regions(alike, options)) {
        contacts.push_back(
            {id_, rubbing(c, friction(materials[i]), deviation(materials[i])), c.gap});
      }
    }
    return !points.empty();
  }

  // The patches of each depth of its materials; a patch is of the material at its centre.
  void add_patches(std::vector<GraspContact>& contacts) {
    std::vector<double> depths;
    for (int o = -1; o < scene_.object_surface.regions(); ++o) {
      for (int l = -1; l < link_.surface.regions(); ++l) {
        const double depth_here = depth({o, l});
        const bool is_new = std::find(depths.begin(), depths.end(), depth_here) == depths.end();
        if (depth_here > 0.0 && is_new) depths.push_back(depth_here);
      }
    }
    for (const double depth_here : depths) {
      soft_patches(scene_.object().mesh, link_.mesh, X_OL_, depth_here, workspace_.soft,
                   workspace_.patches);
      for (const SoftPatch& patch : workspace_.patches) {
        const TouchingRegions at = regions_at(patch.position);
        if (depth(at) != depth_here) continue;
        contacts.push_back({id_, rubbing(patch, friction(at), deviation(at)), patch.gap});
      }
    }
  }

  // Gives contacts the friction of the materials that touch at each.
  void rub(std::span<GraspContact> contacts) const {
    for (GraspContact& contact : contacts) {
      const TouchingRegions at = regions_at(contact.point.position);
      contact.point.friction = friction(at);
      contact.point.friction_deviation = deviation(at);
    }
  }

 private:
  TouchingRegions regions_at(const Vector3& p_O) const {
    return {scene_.object_surface.region_at(p_O), link_.surface.region_at(X_LO_ * p_O)};
  }
  double friction(const TouchingRegions& at) const {
    return friction_between(scene_.scene.friction, scene_.object_surface.of(at.of_object),
                            link_.surface.of(at.of_link));
  }
  double depth(const TouchingRegions& at) const {
    return depth_between(scene_.scene.compliant_depths, scene_.object_surface.of(at.of_object),
                         link_.surface.of(at.of_link));
  }
  std::optional<double> deviation(const TouchingRegions& at) const {
    return scene_.scene.friction_deviations.between(scene_.object_surface.of(at.of_object).material,
                                                    link_.surface.of(at.of_link).material);
  }

  const CompiledScene& scene_;
  const CompiledLink& link_;
  LinkId id_;
  const Pose& X_OL_;
  Pose X_LO_;
  GraspContactsWorkspace& workspace_;
};

}  // namespace

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
    if (!scene.is_uniform(link)) {
      PartedContacts parted(scene, link_id(l), X_OL, workspace);
      const bool touches = parted.add_points(options.contact, contacts);
      if (touches && options.contacts == ContactKind::fem && link.pad) {
        const std::size_t first = contacts.size();
        add_pad_contacts(scene, X_OH, l, workspace.all_touching, options.pads, workspace, contacts);
        parted.rub(std::span(contacts).subspan(first));
      } else if (touches && options.contacts != ContactKind::hard) {
        parted.add_patches(contacts);
      }
      continue;
    }
    find_contacts(object, link.mesh, X_OL, options.contact, workspace.regions, workspace.touching);
    for (const SurfaceContact& c : workspace.touching) {
      contacts.push_back({link_id(l), rubbing(c, link.friction, link.friction_deviation), c.gap});
    }
    // A soft link that touches has its rigid contacts, which lie within the contact threshold, and
    // in addition those of the patches on which it bears.
    if (options.contacts == ContactKind::hard || workspace.touching.empty()) continue;
    if (options.contacts == ContactKind::fem && link.pad) {
      add_pad_contacts(scene, X_OH, l, workspace.touching, options.pads, workspace, contacts);
      continue;
    }
    if (link.compliant_depth <= 0.0) continue;
    soft_patches(object, link.mesh, X_OL, link.compliant_depth, workspace.soft, workspace.patches);
    for (const SoftPatch& patch : workspace.patches) {
      contacts.push_back(
          {link_id(l), rubbing(patch, link.friction, link.friction_deviation), patch.gap});
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
