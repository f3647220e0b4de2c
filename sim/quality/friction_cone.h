// The forces that a contact's friction allows, as a cone over a few coordinates.
#pragma once

#include <Eigen/Core>

#include "sim/base/named_enum.h"
#include "sim/quality/contact.h"

namespace prehend {

// The shape of the set of allowed forces.
enum class FrictionCone {
  exact,    // the quadratic cone of the contact's model
  pyramid,  // the hull of the corners of contact_wrenches
};

constexpr auto enum_names(FrictionCone /*of*/) {
  return std::to_array<std::string_view>({"exact", "pyramid"});
}

// The allowed forces of one contact. What it transmits, [normal force, force along the first and
// second tangent, torque about the normal], is `transmits` v, where the coordinates v are in a
// second-order cone (v0 >= |(v1, v2, ...)|) if `second_order`, and each >= 0 otherwise.
struct ContactCone {
  Eigen::Matrix<double, 4, Eigen::Dynamic> transmits;
  bool second_order = false;

  // Number of coordinates.
  Eigen::Index size() const { return transmits.cols(); }

  // The smallest value of loads . f over the forces f of unit normal force.
  double lowest(const Eigen::Vector4d& loads) const;
  // A force f of unit normal force with that value; always the same one.
  Eigen::Vector4d lowest_force(const Eigen::Vector4d& loads) const;
};

// A contact without friction has one coordinate, a point contact three, a soft finger four; in a
// pyramid with `edges` (3 to 1024) edges each corner has one.
ContactCone contact_cone(const Contact& contact, FrictionCone cone, int edges);

}  // namespace prehend
