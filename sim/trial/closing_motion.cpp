#include "sim/trial/closing_motion.h"

#include <algorithm>
#include <cmath>

namespace prehend {
namespace {

// The joint at the root of the finger that the joint belongs to.
int first_joint_of_finger(const Robot& hand, int joint) {
  while (hand.joints[index(joint)].parent >= 0) joint = hand.joints[index(joint)].parent;
  return joint;
}

// Axes that are parallel up to this sine turn each other by next to nothing.
constexpr double kParallel = 1e-9;

}  // namespace

void ClosingMotion::start(const Robot& hand, const std::vector<double>& dofs,
                          const std::vector<double>& joints) {
  hand_ = &hand;
  if (joints.empty()) {
    joint_values(hand, dofs, start_);
  } else {
    start_ = joints;
  }
  velocity_.assign(hand.joints.size(), 0.0);
  until_.assign(hand.joints.size(), 0.0);
  by_contact_.assign(hand.joints.size(), false);
  for (std::size_t j = 0; j < hand.joints.size(); ++j) {
    const DegreeOfFreedom& dof = hand.dofs[index(hand.joints[j].dof)];
    const double from = dofs[index(hand.joints[j].dof)];
    const double v = dof.closing_velocity;
    if (v == 0.0) continue;
    velocity_[j] = hand.joints[j].ratio * v;
    until_[j] = std::max(0.0, ((v > 0.0 ? dof.upper : dof.lower) - from) / v);
  }
  find_axes();
}

// The axes of a finger whose joints are all parallel keep their directions while it closes.
void ClosingMotion::find_axes() {
  joint_poses(*hand_, start_, X_HJ_);
  axis_H_.resize(start_.size());
  keeps_axis_.assign(start_.size(), true);
  for (std::size_t j = 0; j < start_.size(); ++j) {
    const Joint& joint = hand_->joints[j];
    axis_H_[j] = joint.X_PJ.linear() * joint.axis;
    if (joint.parent >= 0) axis_H_[j] = X_HJ_[index(joint.parent)].linear() * axis_H_[j];
    for (int before = joint.parent; before >= 0; before = hand_->joints[index(before)].parent) {
      const std::size_t b = index(before);
      if (hand_->joints[b].type != JointType::revolute || velocity_[b] == 0.0) continue;
      if (axis_H_[j].cross(axis_H_[b]).norm() > kParallel) keeps_axis_[j] = false;
    }
  }
}

double ClosingMotion::speed(const CompiledLink& link, double t) const {
  double sum = 0.0;
  for (std::size_t k = 0; k < link.joints.size(); ++k) {
    if (moves(link.joints[k], t)) sum += std::abs(velocity_[index(link.joints[k])]) * link.reach[k];
  }
  return sum;
}

// A turn about an axis carries a point along a direction no farther than the part of the direction
// across the axis lets it.
double ClosingMotion::speed_along(const CompiledLink& link, const Vector3& direction_H,
                                  double t) const {
  double sum = 0.0;
  for (std::size_t k = 0; k < link.joints.size(); ++k) {
    if (!moves(link.joints[k], t)) continue;
    const std::size_t j = index(link.joints[k]);
    const double speed = std::abs(velocity_[j]) * link.reach[k];
    if (!keeps_axis_[j]) {
      sum += speed;
    } else if (hand_->joints[j].type == JointType::revolute) {
      sum += speed * std::min(1.0, axis_H_[j].cross(direction_H).norm() + 2.0 * kParallel);
    } else {
      sum += std::max(0.0, velocity_[j] * axis_H_[j].dot(direction_H)) + speed * kParallel;
    }
  }
  return sum;
}

double ClosingMotion::farthest(const CompiledLink& link) const {
  double sum = 0.0;
  for (std::size_t k = 0; k < link.joints.size(); ++k) {
    const std::size_t j = index(link.joints[k]);
    const int dof = hand_->joints[j].dof;
    double way = 0.0;
    for (std::size_t other = 0; other < hand_->joints.size(); ++other) {
      if (other == j || (hand_->joints[other].dof == dof &&
                         hand_->dofs[index(dof)].coupling == Coupling::self_centering)) {
        way += until_[other];
      }
    }
    sum += std::abs(velocity_[j]) * way * link.reach[k];
  }
  return sum;
}

void ClosingMotion::stop_before(const CompiledLink& link, double t) {
  for (int joint : link.joints) {
    if (!moves(joint, t)) continue;
    stop(joint, t);
    const int dof = hand_->joints[index(joint)].dof;
    const Coupling coupling = hand_->dofs[index(dof)].coupling;
    if (coupling != Coupling::rigid && coupling != Coupling::by_finger) continue;
    const int finger = first_joint_of_finger(*hand_, joint);
    for (std::size_t other = 0; other < hand_->joints.size(); ++other) {
      const auto o = static_cast<int>(other);
      if (hand_->joints[other].dof != dof) continue;
      if (coupling == Coupling::rigid || first_joint_of_finger(*hand_, o) == finger) stop(o, t);
    }
  }
}

double ClosingMotion::end() const {
  return until_.empty() ? 0.0 : *std::max_element(until_.begin(), until_.end());
}

void ClosingMotion::joints_at(double t, std::vector<double>& joints) const {
  joints.resize(start_.size());
  for (std::size_t j = 0; j < start_.size(); ++j) {
    joints[j] = start_[j] + velocity_[j] * std::min(t, until_[j]);
  }
}

void ClosingMotion::move_to_end(std::vector<double>& dofs) const {
  for (std::size_t d = 0; d < dofs.size(); ++d) {
    double longest = 0.0;
    for (std::size_t j = 0; j < hand_->joints.size(); ++j) {
      if (index(hand_->joints[j].dof) == d && velocity_[j] != 0.0)
        longest = std::max(longest, until_[j]);
    }
    dofs[d] += hand_->dofs[d].closing_velocity * longest;
  }
}

void ClosingMotion::stop(int joint, double t) {
  if (!moves(joint, t)) return;
  const double unused = until_[index(joint)] - t;
  until_[index(joint)] = t;
  by_contact_[index(joint)] = true;
  const int dof = hand_->joints[index(joint)].dof;
  if (hand_->dofs[index(dof)].coupling != Coupling::self_centering) return;
  // Centring (center_hand) sets both joints to their mean. So the other finger may pass its limit
  // by what this one leaves unused, and the mean is still inside the limits.
  for (std::size_t other = 0; other < hand_->joints.size(); ++other) {
    if (hand_->joints[other].dof == dof && !by_contact_[other]) until_[other] += unused;
  }
}

}  // namespace prehend
