// What a sealed suction cup can exert on an object, as a convex set of wrenches.
#pragma once

#include <array>

#include <Eigen/Core>

#include "sim/quality/contact.h"
#include "sim/quality/contact_map.h"

namespace prehend {

// The unit of a cup is the force V of its vacuum, as that of a finger is a unit normal force: all
// forces below are multiples of V. The contact's normal n points out of the cup into the object.
// The cup transmits the force z along n (z < 0: it pulls), tangential forces t and a torque about
// n, and a torque m about the tangents. Its lip is pressed onto the object with
//
//   l = z + 1 >= 0            the vacuum presses with 1, of which a pull takes away
//   l <= 2                    the hand pushes no harder than the vacuum does
//   |t|^2 + (torque about n / radius)^2 <= (friction l)^2
//   |m| <= radius l / 2       a ring of springs pressed with l: one side of it is relaxed
//   |m| <= Contact::moment    the lip is no longer elastic (pi r kappa / V in the source)
//
// A set that contains the origin in its inside where friction and moment are above 0: one sealed
// cup is in force closure, and epsilon of it is the smallest of what it pulls, holds sideways,
// turns and tilts. Source: Mahler et al., "Dex-Net 3.0: Computing robust vacuum suction grasp
// targets", ICRA 2018, section IV, the suction ring contact model (which approximates the cones by
// boxes inside them, and has no bound by the relaxed side).

// The largest torque about a tangent with this force on the lip, for a unit vacuum force [m].
double largest_tilt(const Contact& cup, double lip_force);

// The forces on the lip at which the bounds of a cup change, ascending: 0, where the elastic bound
// of the torque replaces that of the relaxed side, and 2.
std::array<double, 3> lip_levels(const Contact& cup);

// The wrenches of unit torques about the first and the second tangent (contact_tangents).
using TiltMap = Eigen::Matrix<double, 6, 2>;
TiltMap tilt_map(const Contact& cup, const WrenchFrame& frame);

// The set's support point: the farthest along `direction`.
Wrench cup_support(const Contact& cup, const WrenchFrame& frame, const Wrench& direction);

// How many columns cup_corners makes.
int cup_corner_count(int edges);

// The corners of a polytope inside the set, whose friction is that of a soft finger's pyramid with
// these edges and whose torques about tangents are in a polygon of as many corners (16 at most).
// `corners` is 6 x cup_corner_count(edges): the one with the full pull, then those of the other two
// lip_levels. `friction` are unit_corners of a soft finger.
void cup_corners(const Contact& cup, const WrenchFrame& frame, int edges,
                 const Eigen::Matrix3Xd& friction, Eigen::Ref<Wrenches> corners);

// The contact of a sealed cup with the elastic bound that follows from the stiffness of its whole
// lip [N/m]: a lip that bends by `strain` times its radius at its edge. The position is the centre
// of the lip, the normal along the cup's axis; `radius` in m, `vacuum` in N.
Contact cup_contact(const Eigen::Vector3d& position, const Eigen::Vector3d& normal, double radius,
                    double friction, double vacuum, double lip_stiffness, double strain);

}  // namespace prehend
