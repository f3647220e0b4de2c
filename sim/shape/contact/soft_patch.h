// The area over which a soft link presses on an object, as one contact with torsional friction.
#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "sim/base/disjoint_sets.h"
#include "sim/shape/contact/surface_contact.h"
#include "sim/shape/contact/triangle_overlap.h"

namespace prehend {

// The resultant of the pressure over one contact patch, in the object's frame O.
struct SoftPatch {
  // On the object, where the line of the resultant force leaves it; nearest to the centre of
  // pressure where that line passes through a hole of the patch [m].
  Vector3 position = Vector3::Zero();
  Vector3 normal = Vector3::UnitZ();  // unit, from the link into the object: mean by pressure
  // Mean distance of the pressure from the normal through its centre. By Coulomb friction at every
  // point, that is the largest torque about the normal over the largest friction force [m].
  double torsion = 0.0;
  double gap = 0.0;    // smallest gap between the surfaces [m]
  double force = 0.0;  // compression integrated over the area, to compare patches [m^3]
};

// A triangle of the object's surface, or a part of one, that presses springs.
struct PressedPart {
  Corners corners;
  Vector3 normal;               // into the object
  std::array<double, 3> force;  // share at the middle of the edge from corner i [m^3]
  std::array<double, 3> gap;    // there
  int triangle = 0;             // of the object

  Vector3 middle(std::size_t i) const { return 0.5 * (corners[i] + corners[(i + 1) % 3]); }
};

// Buffers of soft_patches, to allocate less; one for each thread.
struct SoftPatchWorkspace {
  std::vector<TrianglePair> pairs;
  std::vector<PressedPart> parts;
  DisjointSets connected;  // of the object's vertices; all single between two uses
  std::vector<std::pair<std::size_t, std::size_t>> order;  // patch and part, patch by patch
  std::vector<PressedPart> patch;                          // the parts of one patch
};

// Patches that bear less than this part of the force of the strongest are left out.
inline constexpr double kWeakestPatch = 0.1;

// The contact patches of a soft link, as an elastic foundation (Johnson, "Contact Mechanics", 1985,
// section 4.3): the link's surface is covered with independent springs of length `depth` [m], and
// each is compressed by as much as the object reaches into it. The surfaces themselves do not
// intersect. Pressed triangles of the object belong to one patch where they are connected through
// shared vertices. The patches come strongest first; those that bear less than
// kWeakestPatch of the strongest's force are left out. `X_OL` is the link's pose in the
// object's frame O. `patches` is replaced.
void soft_patches(const ProximityMesh& object, const ProximityMesh& link, const Pose& X_OL,
                  double depth, SoftPatchWorkspace& workspace, std::vector<SoftPatch>& patches);

}  // namespace prehend
