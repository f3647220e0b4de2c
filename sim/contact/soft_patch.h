// The area over which a soft link presses on an object, as one contact with torsional friction.
#pragma once

#include <vector>

#include "sim/contact/surface_contact.h"

namespace prehend {

// The resultant of the pressure over one contact patch, in the object's frame O.
struct SoftPatch {
  Vector3 position = Vector3::Zero();  // on the object, nearest to the centre of pressure [m]
  Vector3 normal = Vector3::UnitZ();   // unit, from the link into the object: mean by pressure
  // Mean distance of the pressure from the normal through its centre. By Coulomb friction at every
  // point, that is the largest torque about the normal over the largest friction force [m].
  double torsion = 0.0;
  double gap = 0.0;    // smallest gap between the surfaces [m]
  double force = 0.0;  // compression integrated over the area, to compare patches [m^3]
};

// The contact patches of a soft link, as an elastic foundation (Johnson, "Contact Mechanics", 1985,
// section 4.3): the link's surface is covered with independent springs of length `depth` [m], and
// each is compressed by as much as the object reaches into it. The surfaces themselves do not
// intersect. Pressed triangles of the object belong to one patch where they are connected through
// shared vertices. The patches come strongest first; those that bear less than
// `options.weakest_patch` of the strongest's force are left out. `X_OL` is the link's pose in the
// object's frame O.
std::vector<SoftPatch> soft_patches(const ProximityMesh& object, const ProximityMesh& link,
                                    const Pose& X_OL, double depth, const ContactOptions& options,
                                    ContactWorkspace& workspace);

}  // namespace prehend
