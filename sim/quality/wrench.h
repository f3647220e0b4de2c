// Wrenches that contacts can exert: columns [force; torque / r].
#pragma once

#include <span>

#include <Eigen/Core>

#include "sim/quality/contact.h"

namespace prehend {

using Wrench = Eigen::Matrix<double, 6, 1>;
using Wrenches = Eigen::Matrix<double, 6, Eigen::Dynamic>;

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

// Column edges * i + j is the wrench of edge j of contact i's friction pyramid with `edges` (>= 3)
// edges and a unit normal force: f = n + friction (cos(2 pi j / edges) t + sin(...) n x t), with
// t the first tangent. Torque is (position - origin) x f times the scale.
// Frictionless contacts keep all their (equal) columns.
// Source: Miller and Allen, "GraspIt!", 2004, Building the Grasp Wrench Space, eq. (1).
// Throws std::invalid_argument on a value that is not finite, a normal that is not unit within
// 1e-3 (a nearly unit one is normalised), negative friction, a scale that is not positive, or fewer
// than 3 edges; it names the contact.
Wrenches contact_wrenches(std::span<const PointContact> contacts, const WrenchFrame& frame,
                          int edges = 8);

}  // namespace prehend
