// Reduces contact points to the corners of the regions in which two surfaces touch.
#pragma once

#include <vector>

#include "sim/contact/surface_contact.h"

namespace prehend {

// Reduces `contacts`, given nearest first as find_contact_points does, to the corners of their
// contact regions. Contacts with the same normal (up to the angular tolerance) form a group. A
// point contact, all within the threshold of the group's nearest contact, keeps that contact; a
// line contact its two ends; an area contact the corners of its convex hull in the plane orthogonal
// to the normal. The wrench of any force distribution over a line or an area is also one of forces
// at these corners, so no wrench is lost except where `flat_corner` and `max_region_corners` leave
// corners out, which only ever shrinks the region. Order: groups by their nearest contact, corners
// counter-clockwise about the normal. Source: Miller and Allen 2004, "Contact Determination".
std::vector<SurfaceContact> contact_regions(const std::vector<SurfaceContact>& contacts,
                                            const ContactOptions& options);

// The contacts of a link with the object: find_contact_points, then contact_regions. `X_OL` is the
// link's pose in the object's frame O.
std::vector<SurfaceContact> find_contacts(const ProximityMesh& object, const ProximityMesh& link,
                                          const Pose& X_OL, const ContactOptions& options,
                                          ContactWorkspace& workspace);

}  // namespace prehend
