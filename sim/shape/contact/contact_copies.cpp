#include "sim/shape/contact/contact_copies.h"

#include <algorithm>
#include <cmath>

// Contacts at the same place are at about the same height along any direction. So each is compared
// only with its neighbours in the order of heights. The direction is an oblique one: surfaces often
// run along the axes of their frame, and then many contacts are at one height along an axis.
namespace prehend {
namespace {

void sort_by_height(const std::vector<SurfaceContact>& contacts, ContactCopies& workspace) {
  const Vector3 oblique = Vector3(0.6178, 0.4973, 0.6091).normalized();
  std::vector<ContactHeight>& by_height = workspace.by_height;
  by_height.clear();
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    by_height.push_back({oblique.dot(contacts[i].position), i, false});
  }
  std::sort(by_height.begin(), by_height.end(), [](const ContactHeight& a, const ContactHeight& b) {
    return a.height != b.height ? a.height < b.height : a.contact < b.contact;
  });
  workspace.place.resize(contacts.size());
  for (std::size_t at = 0; at < by_height.size(); ++at) workspace.place[by_height[at].contact] = at;
}

}  // namespace

void first_copies(const std::vector<SurfaceContact>& contacts, const ContactOptions& options,
                  ContactCopies& workspace, std::vector<SurfaceContact>& firsts) {
  sort_by_height(contacts, workspace);
  firsts.clear();
  std::vector<ContactHeight>& by_height = workspace.by_height;
  const double same_place = kSamePlace * options.threshold;
  // The heights are rounded, of places that may be far from the origin.
  const double same_height = 1.5 * same_place;
  const auto is_copy = [&](const SurfaceContact& contact, const ContactHeight& other) {
    const SurfaceContact& kept = contacts[other.contact];
    return other.kept && (kept.position - contact.position).norm() <= same_place &&
           kept.normal.cross(contact.normal).norm() <= 2.0 * options.angular_tolerance &&
           kept.normal.dot(contact.normal) > 0.0;
  };
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const std::size_t own = workspace.place[i];
    const double height = by_height[own].height;
    bool copy = false;
    for (std::size_t at = own; !copy && at-- > 0;) {
      if (height - by_height[at].height > same_height) break;
      copy = is_copy(contacts[i], by_height[at]);
    }
    for (std::size_t at = own + 1; !copy && at < by_height.size(); ++at) {
      if (by_height[at].height - height > same_height) break;
      copy = is_copy(contacts[i], by_height[at]);
    }
    if (copy) continue;
    by_height[own].kept = true;
    firsts.push_back(contacts[i]);
  }
}

}  // namespace prehend
