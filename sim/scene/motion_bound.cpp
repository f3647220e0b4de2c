#include "sim/scene/motion_bound.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "sim/base/index.h"
#include "sim/scene/compiled_arm.h"

namespace prehend {
MotionBound::MotionBound(const CompiledArm& arm) : arm_(arm), from_base_(arm.links.size(), -1.0) {
  for (const Joint& joint : arm.robot().joints) {
    const Pose X_AJ = joint.X_JA.inverse();
    axes_.push_back({X_AJ.linear() * joint.axis, X_AJ.translation()});
  }
}

void MotionBound::set(const RobotPoses& poses, const std::vector<double>& turns, Motion motion) {
  poses_ = &poses;
  turns_ = &turns;
  motion_ = motion;
  std::fill(from_base_.begin(), from_base_.end(), -1.0);
}

double MotionBound::farthest(const ArmPair& pair) {
  const CompiledLink& link = arm_.links[index(pair.link)];
  if (const auto* other = std::get_if<LinkId>(&pair.other)) {
    const CompiledLink& second = arm_.links[index(*other)];
    const std::size_t shared = shared_joints(link, second);
    return branch(link, shared) + branch(second, shared);
  }
  double& known = from_base_[index(pair.link)];
  if (known < 0.0) known = branch(link, 0);
  return known;
}

// The farthest that a point of the link moves relative to the frame before its joint number
// `shared`.
double MotionBound::branch(const CompiledLink& link, std::size_t shared) const {
  if (link.joints.empty()) return 0.0;
  const Vector3 p_B = poses_->X_BJ[index(link.joints.back())] * link.mesh.ball_center();
  const double radius = link.mesh.ball_radius();
  double moved = 0.0;  // the most by the joints so far
  double speed = 0.0;  // the most on a line, and the acceleration
  double acceleration = 0.0;
  Vector3 velocity = Vector3::Zero();  // of p in the posture
  Vector3 spin = Vector3::Zero();      // of the link
  for (std::size_t k = link.joints.size(); k-- > shared;) {
    const std::size_t j = index(link.joints[k]);
    const double change = (*turns_)[j];
    const double turn = std::abs(change);
    if (turn == 0.0) continue;
    const Pose& X_BA = poses_->X_BJ[j];
    const Vector3 axis = X_BA.linear() * axes_[j].direction;
    double here = 1.0;  // distances of points from the axis, 1 for a slide: in the posture
    double most = 1.0;  // and on all of the way
    if (arm_.robot().joints[j].type == JointType::revolute) {
      const Vector3 across = axis.cross(p_B - X_BA * axes_[j].point);
      here = std::min(link.reach[k], across.norm() + radius);
      most = std::min(link.reach[k], here + moved);
      velocity += change * across;
      spin += change * axis;
    } else {
      velocity += change * axis;
    }
    acceleration += turn * (turn * most + 2.0 * speed);
    speed += turn * most;
    moved += turn * here;
  }
  if (motion_ == Motion::any) return moved;
  return std::min(moved, velocity.norm() + spin.norm() * radius + 0.5 * acceleration);
}

}  // namespace prehend
