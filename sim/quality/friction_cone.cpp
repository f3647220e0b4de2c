#include "sim/quality/friction_cone.h"

#include "sim/quality/wrench.h"

namespace prehend {

// The loads as a linear function of the coordinates v, minimised at unit normal force. In a
// second-order cone the normal force is v0 = 1 and the minimum over |(v1, v2, ...)| <= 1 lies
// opposite to their coefficients. In a pyramid each corner has a normal force of 1, so the
// coordinates add up to 1 and the minimum is at one of the corners.
double ContactCone::lowest(const Eigen::Vector4d& loads) const {
  const Eigen::VectorXd v = transmits.transpose() * loads;
  return second_order ? v[0] - v.tail(v.size() - 1).norm() : v.minCoeff();
}

Eigen::Vector4d ContactCone::lowest_force(const Eigen::Vector4d& loads) const {
  const Eigen::VectorXd v = transmits.transpose() * loads;
  if (!second_order) {
    Eigen::Index corner = 0;
    v.minCoeff(&corner);
    return transmits.col(corner);
  }
  const double length = v.tail(v.size() - 1).norm();
  Eigen::VectorXd best = Eigen::VectorXd::Unit(v.size(), 0);
  if (length > 0.0) best.tail(v.size() - 1) = -v.tail(v.size() - 1) / length;
  return transmits * best;
}

// Scaled by [1, mu, mu, mu torsion], mu the friction, the cone v0 >= |(v1, v2, v3)| becomes that of
// the contact model, |f_t|^2 + (t / torsion)^2 <= (mu f_n)^2. A direction in which the contact
// transmits nothing gets no coordinate: each coordinate changes the force, and the map from
// coordinates to forces is one to one for the exact cone.
ContactCone contact_cone(const Contact& contact, FrictionCone cone, int edges) {
  const bool slips = contact.model == ContactModel::frictionless || contact.friction == 0.0;
  if (slips) return {Eigen::Vector4d::UnitX(), false};
  const bool twists = contact.model == ContactModel::soft_finger && contact.torsion > 0.0;
  const ContactModel model = twists ? ContactModel::soft_finger : ContactModel::point;
  const Eigen::Vector4d size(1.0, contact.friction, contact.friction,
                             contact.friction * contact.torsion);
  if (cone == FrictionCone::exact) {
    const Eigen::Matrix4d axes = size.asDiagonal();
    return {axes.leftCols(twists ? 4 : 3), true};
  }
  const Eigen::Matrix3Xd corners = unit_corners(model, edges);
  ContactCone pyramid;
  pyramid.transmits.resize(4, corners.cols());
  pyramid.transmits.row(0).setOnes();
  pyramid.transmits.bottomRows<3>() = size.tail<3>().asDiagonal() * corners;
  return pyramid;
}

}  // namespace prehend
