// Wrenches that contacts can exert, as the corners of pyramids: columns [force; torque * scale].
#pragma once

#include <span>

#include <Eigen/Core>

#include "sim/quality/contact.h"
#include "sim/quality/contact_map.h"

namespace prehend {

// The corners of each contact's friction cone with `edges` (3 to 1024) edges, cut at a unit normal
// force, contact after contact. A point contact has `edges` columns: edge j is n + friction (cos(2
// pi j / edges) t + sin(...) n x t), with t the first tangent. A frictionless contact keeps all its
// (equal) columns. A soft finger has pyramid_corners() of them on its ellipsoid: those of a point
// contact, then as many at the latitudes of 45 degrees to either side, then the two poles (torque
// only). A suction cup has cup_corners (suction_cup.h). Source: Miller and Allen, "GraspIt!", 2004,
// Building the Grasp Wrench Space, eq. (1). Throws as check_contacts and check_edges.
Wrenches contact_wrenches(std::span<const Contact> contacts, const WrenchFrame& frame,
                          int edges = 8);

// Throws InputError for a number of edges outside its range (ranges.h).
void check_edges(int edges);

// How many columns contact_wrenches makes of a contact.
int pyramid_corners(ContactModel model, int edges);

// Their tangential parts for a unit normal force and unit friction, in columns of the same order:
// [force along the first and second tangent, torque about the normal over torsion]. Those of a
// suction cup are those of a soft finger.
Eigen::Matrix3Xd unit_corners(ContactModel model, int edges);

}  // namespace prehend
