#include "sim/quality/force_balance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/base/index.h"

namespace prehend {
namespace {

// Bounds the rounding error of the products of a separation with a contact's maps, relative to the
// sum of their magnitudes.
constexpr double kRounding = 8.0 * std::numeric_limits<double>::epsilon();

}  // namespace

ForceBalance::ForceBalance(std::span<const Contact> contacts, const WrenchFrame& frame,
                           const Wrench& wrench, double size, const HandTorques* hand,
                           const ForceOptions& options)
    : measure_(options.measure), wrench_(wrench) {
  add_contacts(contacts, frame, options);
  if (hand != nullptr) add_joints(contacts, *hand, size);
}

void ForceBalance::add_contacts(std::span<const Contact> contacts, const WrenchFrame& frame,
                                const ForceOptions& options) {
  maps_.resize(6, 4 * std::ssize(contacts));
  loads_.resize(0, maps_.cols());
  for (const Contact& contact : contacts) {
    maps_.middleCols<4>(4 * std::ssize(cones_)) = contact_map(contact, frame);
    cones_.push_back(contact_cone(contact, options.cone, options.edges));
  }
}

// The Jacobian is in the axes of the contacts, but components are along the normal and the
// tangents: each contact's three rows are turned into those axes.
void ForceBalance::add_joints(std::span<const Contact> contacts, const HandTorques& hand,
                              double size) {
  loads_ = Eigen::MatrixXd::Zero(hand.limits.size(), maps_.cols());
  limits_ = hand.limits / size;
  for (Eigen::Index i = 0; i < std::ssize(contacts); ++i) {
    const Eigen::Vector3d normal = contacts[index(i)].normal.normalized();
    const Tangents tangents = contact_tangents(normal);
    Eigen::Matrix3d axes;
    axes << normal, tangents.first, tangents.second;
    loads_.middleCols<3>(4 * i) = hand.jacobian.middleRows<3>(3 * i).transpose() * axes;
    if (hand.spin.size() > 0) loads_.col(4 * i + 3) = hand.spin.row(i).transpose();
  }
  for (Eigen::Index j = 0; j < limits_.size(); ++j) {
    if (limits_[j] == 0.0) locked_.push_back(j);
    if (limits_[j] > 0.0 && std::isfinite(limits_[j])) limited_.push_back(j);
  }
}

double ForceBalance::measure(const Eigen::Matrix4Xd& components) const {
  if (components.cols() == 0) return 0.0;
  return measure_ == ForceMeasure::sum_of_normals ? components.row(0).sum()
                                                  : components.row(0).maxCoeff();
}

double ForceBalance::residual(const Eigen::Matrix4Xd& components) const {
  return (maps_ * components.reshaped() + wrench_).norm();
}

// The largest part by which a joint torque exceeds its limit. A locked joint has the limit 0: its
// torque is compared with the largest that a single force component of the largest magnitude would
// cause.
double ForceBalance::torque_excess(const Eigen::Matrix4Xd& components) const {
  const Eigen::VectorXd torques = loads_ * components.reshaped();
  double excess = 0.0;
  for (const Eigen::Index j : limited_) {
    excess = std::max(excess, std::abs(torques[j]) / limits_[j] - 1.0);
  }
  for (const Eigen::Index j : locked_) {
    const double size = loads_.row(j).cwiseAbs().maxCoeff() * components.cwiseAbs().maxCoeff();
    if (size > 0.0) excess = std::max(excess, std::abs(torques[j]) / size);
  }
  return excess;
}

// Weak duality. Let u be the separation's wrench and l its torques, W the map of forces to wrenches
// and J' that to joint torques. Balanced forces f (W f = -external) within the limits L have
//   u . external - sum |l_j| L_j <= -sum over contacts of (u'W + l'J') f <= sum of f_n d_i,
// where d_i >= 0 is how far the lowest value of (u'W + l'J') f lies below zero over the forces of
// contact i with unit normal force. The right-hand side is at most (sum of f_n) max d_i, and at
// most (largest f_n) sum d_i: dividing by either of these d gives the bound. A residual r of the
// balance lowers the left-hand side by at most |u| r. Rounding makes each d_i larger, never
// smaller.
double ForceBalance::lower_bound(const Separation& separation, ForceMeasure measure,
                                 double residual) const {
  double value = separation.wrench.dot(wrench_) - residual * separation.wrench.norm();
  for (const Eigen::Index j : limited_) value -= std::abs(separation.torques[j]) * limits_[j];
  const Eigen::VectorXd loads =
      maps_.transpose() * separation.wrench + loads_.transpose() * separation.torques;
  const Eigen::VectorXd sizes = maps_.cwiseAbs().transpose() * separation.wrench.cwiseAbs() +
                                loads_.cwiseAbs().transpose() * separation.torques.cwiseAbs();
  double below = 0.0;
  for (Eigen::Index i = 0; i < std::ssize(cones_); ++i) {
    const ContactCone& cone = cones_[index(i)];
    const double rounding = -kRounding * cone.lowest(-sizes.segment<4>(4 * i));
    const double depth = std::max(0.0, -cone.lowest(loads.segment<4>(4 * i))) + rounding;
    below = measure == ForceMeasure::sum_of_normals ? std::max(below, depth) : below + depth;
  }
  if (!(value > 0.0)) return 0.0;
  return below > 0.0 ? value / below : std::numeric_limits<double>::infinity();
}

}  // namespace prehend
