#include "sim/quality/friction_cone.h"

#include "sim/quality/wrench.h"

namespace prehend {

double ContactCone::lowest(const Eigen::Vector4d& loads) const {
  const Eigen::VectorXd v = transmits.transpose() * loads;
  return second_order ? v[0] - v.tail(v.size() - 1).norm() : v.minCoeff();
}

// A direction in which the contact transmits nothing is left out: the cone keeps an interior.
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
