// The search for contacts between the bodies and links of a world.
#pragma once

#include <optional>

#include "sim/motion/contact_memory.h"
#include "sim/shape/contact/surface_contact.h"

namespace prehend {

// Surfaces closer than this are in contact; where they approach each other, those that may meet
// within the step as well [m].
inline constexpr double kContactRange = 2e-4;
// Contacts are searched again after points moved against each other by this [m].
inline constexpr double kContactRefresh = 1e-4;
// Contacts that differ by less than this count once: in place, and in normal times the arm [m].
inline constexpr double kContactsApart = 1e-3;
inline constexpr double kContactArm = 0.02;

// How far two contacts of a pair are from being the same: in place, and in normal times
// kContactArm [m].
double difference(const HeldContact& a, const HeldContact& b);

// Sticks, or slides, from where the solids are now: p_B becomes the point of b opposite to p_A.
void stick_here(const Pose& X_AB, HeldContact& contact);

// The contacts of two meshes that are within `range`; `memory` gets them. X_AB: pose of b's frame
// in a's. Impulses are taken over from those held before at the same places.
void search_contacts(const ProximityMesh& a, const ProximityMesh& b, const Pose& X_AB, double range,
                     ContactWorkspace& workspace, PairMemory& memory);

// A contact at the nearest points of a pair of triangles (of find_gap) that do not meet: for
// surfaces whose contacts are none that search_contacts finds.
HeldContact nearest_contact(const ProximityMesh& a, const ProximityMesh& b, const Pose& X_AB,
                            const TrianglePair& pair);

// A contact for surfaces that cross: in the middle of the triangles that meet, along the mean of
// their normals. Nothing where these cancel each other.
std::optional<HeldContact> crossing_contact(const ProximityMesh& a, const ProximityMesh& b,
                                            const Pose& X_AB);

}  // namespace prehend
