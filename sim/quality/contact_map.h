// How the force at a contact becomes a wrench on the object.
#pragma once

#include <span>

#include <Eigen/Core>

#include "sim/quality/contact.h"

namespace prehend {

using Wrench = Eigen::Matrix<double, 6, 1>;                 // [force; torque * torque_scale]
using Wrenches = Eigen::Matrix<double, 6, Eigen::Dynamic>;  // one a column

// The point about which torques are taken, and the factor that makes them comparable with forces.
struct WrenchFrame {
  Eigen::Vector3d torque_origin = Eigen::Vector3d::Zero();  // m, frame of the contacts
  double torque_scale = 1.0;  // 1 / r, r the object's largest distance from the origin [1/m]
};

// Two unit vectors that span the tangent plane of a unit normal, right-handed: first x second is
// the normal. The first is along normal x X, or normal x Z where the normal is parallel to X (the
// sine of the angle between them is below 1e-6).
struct Tangents {
  Eigen::Vector3d first = Eigen::Vector3d::UnitX();
  Eigen::Vector3d second = Eigen::Vector3d::UnitY();
};
Tangents contact_tangents(const Eigen::Vector3d& normal);

// The 6 x 4 matrix that turns what a contact transmits, [normal force, force along the first and
// second tangent (contact_tangents), torque about the normal], into a wrench on the object, in the
// given frame.
using ContactMap = Eigen::Matrix<double, 6, 4>;
ContactMap contact_map(const Contact& contact, const WrenchFrame& frame);

// Throws InputError whose field is "position", "normal", "friction", "torsion", "moment" or
// "vacuum" on a value that is outside its range (ranges.h), and on a normal that is not unit within
// 1e-3 (a nearly unit one is taken as its direction).
void check_contact(const Contact& contact);

// Throws InputError on a torque origin or scale outside its range.
void check_frame(const WrenchFrame& frame);

// check_frame, and check_contact for each, with the field under "contacts[i]".
void check_contacts(std::span<const Contact> contacts, const WrenchFrame& frame);

}  // namespace prehend
