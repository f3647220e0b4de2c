// The area over which a soft link presses on an object, as one contact with torsional friction.
#pragma once

#include <vector>

#include "sim/contact/surface_contact.h"

namespace prehend {

// The force of one patch, taken together; in the object's frame O.
struct SoftPatch {
  Vector3 position = Vector3::Zero();  // on the object, nearest to the centre of pressure [m]
  Vector3 normal = Vector3::UnitZ();   // unit, from the link into the object: the mean pressure's
  // Mean distance of the pressure from the centre: largest torque about the normal over largest
  // friction force [m].
  double torsion = 0.0;
  double gap = 0.0;    // smallest between the surfaces [m]
  double force = 0.0;  // pressure over area, for comparison of patches [m^3]
};

// The link, at rest with a gap to the object, is a bed of independent springs of which those nearer
// than `depth` [m] are pressed, each by as much as the object lies inside that depth: an elastic
// foundation (Johnson, "Contact Mechanics", 1985, section 4.3). Patches are apart where they share
// no vertex of the object; the strongest comes first, and those below `weakest_patch` of it are
// left out.
std::vector<SoftPatch> soft_patches(const ProximityMesh& object, const ProximityMesh& link,
                                    const Pose& X_OL, double depth, const ContactOptions& options,
                                    ContactWorkspace& workspace);

}  // namespace prehend
