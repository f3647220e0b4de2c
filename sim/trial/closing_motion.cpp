#include "sim/trial/closing_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/shape/separation.h"

namespace prehend {
namespace {

// Axes that are parallel up to this sine turn each other by next to nothing.
constexpr double kParallel = 1e-9;

// The largest value >= 0 of lever . (p - c) over the points p of a part of a link, where c is on
// the axis of joint k of those before it.
double moment_of(const ConvexPoints& part, const ClosingLink& placed, std::size_t k,
                 const Vector3& lever) {
  const double length = lever.norm();
  if (length == 0.0) return 0.0;
  const Vector3 direction_H = lever / length;
  const Vector3& farthest = part.farthest(placed.X_HL.linear().transpose() * direction_H);
  const double along = direction_H.dot(placed.X_HL * farthest - placed.on_axis_H[k]);
  return std::max(0.0, length * (along + part.margin() + part.search_error()));
}

}  // namespace

TravelBound& TravelBound::operator+=(const TravelBound& other) {
  steady += other.steady;
  now += other.now;
  growth += other.growth;
  return *this;
}

double TravelBound::time_for(double distance) const {
  const double growing = now + std::sqrt(now * now + 2.0 * growth * distance);
  const double never = std::numeric_limits<double>::infinity();
  return std::max(steady > 0.0 ? distance / steady : never,
                  growing > 0.0 ? 2.0 * distance / growing : never);
}

void ClosingMotion::start(const Robot& hand, const std::vector<double>& dofs,
                          const std::vector<double>& joints) {
  hand_ = &hand;
  closing_.clear();
  for (const DegreeOfFreedom& dof : hand.dofs) {
    closing_.push_back({dof.closing_velocity, dof.closing_velocity > 0.0 ? dof.upper : dof.lower});
  }
  course_.start(hand, dofs, closing_, joints);
  find_axes();
}

// The axes of a finger whose joints are all parallel keep their directions while it closes.
void ClosingMotion::find_axes() {
  const std::size_t count = hand_->joints.size();
  joint_poses(*hand_, course_.at_start(), X_HJ_);
  placed_.assign(count, {std::numeric_limits<double>::quiet_NaN(), Pose::Identity()});
  axis_H_.resize(count);
  keeps_axis_.assign(count, true);
  for (std::size_t j = 0; j < count; ++j) {
    const Joint& joint = hand_->joints[j];
    axis_H_[j] = joint.X_PJ.linear() * joint.axis;
    if (joint.parent >= 0) axis_H_[j] = X_HJ_[index(joint.parent)].linear() * axis_H_[j];
    for (int before = joint.parent; before >= 0; before = hand_->joints[index(before)].parent) {
      const std::size_t b = index(before);
      if (hand_->joints[b].type != JointType::revolute || !course_.moves(before, 0.0)) continue;
      if (axis_H_[j].cross(axis_H_[b]).norm() > kParallel) keeps_axis_[j] = false;
    }
  }
}

double ClosingMotion::speed(const CompiledLink& link, double t) const {
  double sum = 0.0;
  for (std::size_t k = 0; k < link.joints.size(); ++k) {
    sum += course_.speed(link.joints[k], t) * link.reach[k];
  }
  return sum;
}

const Pose& ClosingMotion::placed(std::size_t joint, double t) {
  PlacedJoint& placed = placed_[joint];
  const double value = course_.value(static_cast<int>(joint), t);
  if (value != placed.value) {
    placed.value = value;
    placed.X_PA = hand_->joints[joint].X_PJ * across(hand_->joints[joint], value);
  }
  return placed.X_PA;
}

void ClosingMotion::place(const CompiledLink& link, double t, ClosingLink& placed) {
  placed.X_HL = Pose::Identity();
  placed.on_axis_H.clear();
  for (const int j : link.joints) {
    const Vector3& on_axis_P = hand_->joints[index(j)].X_PJ.translation();
    placed.on_axis_H.emplace_back(placed.X_HL * on_axis_P);
    placed.X_HL = placed.X_HL * this->placed(index(j), t);
  }
}

// A turn by the angle v t about the axis a carries a point p along e by v t (a x (p - c)) . e at
// first, c being on the axis. It is less than that by no more than what the turn itself, and
// the joints behind it, change of p - c: to second order. Only the part of e across the axis
// counts, as long as the axis keeps its direction.
TravelBound ClosingMotion::travel_along(const CompiledLink& link, const ConvexPoints& part,
                                        const ClosingLink& placed, const Vector3& direction_H,
                                        double t) const {
  TravelBound bound;
  double turning = 0.0;  // of the joints so far: the sum of |v| times the part of e across the axis
  bool is_steady = true;
  for (std::size_t k = 0; k < link.joints.size(); ++k) {
    if (!course_.moves(link.joints[k], t)) continue;
    const std::size_t j = index(link.joints[k]);
    const double v = course_.velocity(link.joints[k], t);
    const double speed = course_.speed(link.joints[k], t) * link.reach[k];
    bound.growth += 2.0 * turning * speed;
    if (!keeps_axis_[j] || course_.may_turn(link.joints[k], t)) {
      is_steady = false;
      bound.steady += speed;
    } else if (hand_->joints[j].type == JointType::prismatic) {
      const double along = std::max(0.0, v * axis_H_[j].dot(direction_H)) + speed * kParallel;
      bound.steady += along;
      bound.now += along;
    } else {
      const Vector3 lever = (v > 0.0 ? direction_H : Vector3(-direction_H)).cross(axis_H_[j]);
      const double across = std::min(1.0, lever.norm() + 2.0 * kParallel);
      bound.steady += speed * across;
      bound.now += std::min(speed * across, std::abs(v) * moment_of(part, placed, k, lever));
      bound.growth += std::abs(v) * speed * across;
      turning += std::abs(v) * across;
    }
  }
  if (!is_steady) return {bound.steady, bound.steady, 0.0};
  return bound;
}

double ClosingMotion::farthest(const CompiledLink& link) const {
  double sum = 0.0;
  for (std::size_t k = 0; k < link.joints.size(); ++k) {
    const int j = link.joints[k];
    const int dof = hand_->joints[index(j)].dof;
    double way = 0.0;
    for (int other = 0; other < static_cast<int>(hand_->joints.size()); ++other) {
      if (other == j || (hand_->joints[index(other)].dof == dof &&
                         hand_->dofs[index(dof)].coupling == Coupling::self_centering)) {
        way += course_.until(other);
      }
    }
    sum += course_.speed(j, 0.0) * way * link.reach[k];
  }
  return sum;
}

void ClosingMotion::joints_at(double t, std::vector<double>& joints) const {
  joints.resize(hand_->joints.size());
  for (std::size_t j = 0; j < joints.size(); ++j) {
    joints[j] = course_.value(static_cast<int>(j), t);
  }
}

void ClosingMotion::move_to_end(std::vector<double>& dofs) const {
  for (std::size_t d = 0; d < dofs.size(); ++d) {
    if (closing_[d].velocity == 0.0) continue;
    double longest = 0.0;
    for (std::size_t j = 0; j < hand_->joints.size(); ++j) {
      if (index(hand_->joints[j].dof) == d) {
        longest = std::max(longest, course_.until(static_cast<int>(j)));
      }
    }
    dofs[d] += closing_[d].velocity * longest;
  }
}

}  // namespace prehend
