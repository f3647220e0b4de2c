// Reduces contact points to the corners of the regions in which two surfaces touch.
#pragma once

#include <vector>

#include "sim/contact/surface_contact.h"

namespace prehend {

// Reduces `contacts` to the corners of their regions: contacts with one normal form a group; a
// group within the threshold of its nearest contact keeps that one, a group on a line its two ends,
// any other the corners of its planar convex hull. A force spread over a line or an area is a
// convex combination of forces at those corners, so nothing is lost but what `max_region_corners`
// cuts off (always inward). Order: groups by their nearest point, corners counter-clockwise about
// the normal. Source: Miller and Allen 2004, "Contact Determination".
std::vector<SurfaceContact> contact_regions(const std::vector<SurfaceContact>& contacts,
                                            const ContactOptions& options);

// find_contact_points, then contact_regions.
std::vector<SurfaceContact> find_contacts(const ProximityMesh& object, const ProximityMesh& link,
                                          const Pose& X_OL, const ContactOptions& options,
                                          ContactWorkspace& workspace);

}  // namespace prehend
