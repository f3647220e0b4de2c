// Reduces contact points to the corners of the regions in which two surfaces touch.
#pragma once

#include <cstddef>
#include <vector>

#include "sim/base/reused_list.h"
#include "sim/shape/contact/surface_contact.h"

namespace prehend {

// Reduces `contacts`, given nearest first as find_contact_points does, to the corners of their
// contact regions. Contacts with the same normal (up to the angular tolerance) form a group. A
// point contact, all within the threshold of the group's nearest contact, keeps that contact; a
// line contact its two ends; an area contact the corners of its convex hull in the plane orthogonal
// to the normal. The wrench of any force distribution over a line or an area is also one of forces
// at these corners, so no wrench is lost except where flat corners and `max_region_corners` leave
// corners out, which only ever shrinks the region. Order: groups by their nearest contact, corners
// counter-clockwise about the normal. Source: Miller and Allen 2004, "Contact Determination".
std::vector<SurfaceContact> contact_regions(const std::vector<SurfaceContact>& contacts,
                                            const ContactOptions& options);

// A contact in the plane of its group: where it is, and its index in the list of all contacts.
struct RegionPoint {
  Eigen::Vector2d p = Eigen::Vector2d::Zero();
  std::size_t contact = 0;
};

// Buffers of find_contacts, to allocate less; one for each thread.
struct RegionWorkspace {
  ContactWorkspace contacts;
  std::vector<SurfaceContact> points;
  ReusedList<std::vector<std::size_t>> groups;  // indices of contacts
  std::vector<RegionPoint> in_plane;            // of one group
  std::vector<RegionPoint> outline;
};

// The contacts of a link with the object: find_contact_points, then contact_regions. `X_OL` is the
// link's pose in the object's frame O. `contacts` is replaced.
void find_contacts(const ProximityMesh& object, const ProximityMesh& link, const Pose& X_OL,
                   const ContactOptions& options, RegionWorkspace& workspace,
                   std::vector<SurfaceContact>& contacts);

}  // namespace prehend
