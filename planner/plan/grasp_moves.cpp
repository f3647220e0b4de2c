#include "planner/plan/grasp_moves.h"

#include <algorithm>
#include <utility>

#include "sim/base/index.h"

namespace prehend {
namespace {

Vector3 middle_of(const std::vector<GraspContact>& contacts) {
  Vector3 sum = Vector3::Zero();
  for (const GraspContact& contact : contacts) sum += contact.point.position;
  return sum / static_cast<double>(contacts.size());
}

// The rotation about the axis `w` by its length [rad].
Matrix3 rotation_by(const Vector3& w) {
  const double angle = w.norm();
  if (angle == 0.0) return Matrix3::Identity();
  return Eigen::AngleAxisd(angle, w / angle).toRotationMatrix();
}

// Whether something stopped the hand before the end of its approach. The distance of a back-off is
// no stop: there the grasp is where it was found to hold.
bool was_stopped(const Candidate& candidate, const Trial& trial) {
  return trial.back_offs == 0 && trial.travel < candidate.approach_distance;
}

}  // namespace

GraspMoves::GraspMoves(const CompiledScene& scene, const Candidate& candidate, const Trial& trial,
                       const GraspReach& reach)
    : hand_(scene.scene.hand),
      reach_(reach),
      X_OH_(trial.X_OH),
      p_HC_(trial.X_OH.inverse() * middle_of(trial.contacts)),
      approach_H_(candidate.X_OH.linear().transpose() * candidate.approach_O),
      approach_distance_(trial.travel),
      overrun_(was_stopped(candidate, trial) ? kOverrun : 0.0),
      preshape_(candidate.preshape),
      dofs_(candidate.dofs),
      joints_(candidate.joints) {
  const Hand& hand = *hand_.hand;
  R_HA_ << hand.approach, hand.closing, hand.approach.cross(hand.closing);
  if (preshape_) dofs_ = hand.preshapes[index(*preshape_)].dofs;
  // Joints that do not follow their degrees of freedom cannot be moved by these.
  if (reach.spread == 0.0 || !joints_.empty()) return;
  for (std::size_t d = 0; d < hand_.dofs.size(); ++d) {
    const DegreeOfFreedom& dof = hand_.dofs[d];
    if (dof.closing_velocity == 0.0 && dof.lower < dof.upper) free_dofs_.push_back(d);
  }
}

Candidate GraspMoves::at(const std::vector<double>& x) const {
  const Matrix3 turn_H = rotation_by(reach_.turn * (R_HA_ * Vector3(x[0], x[1], x[2])));
  const Vector3 shift_H = reach_.shift * (R_HA_ * Vector3(x[3], x[4], x[5]));
  Candidate candidate;
  // The point C of the hand is moved by the shift, and the hand turned about it.
  candidate.X_OH = X_OH_ * pose_from(turn_H, p_HC_ + shift_H - turn_H * p_HC_);
  candidate.approach_O = candidate.X_OH.linear() * approach_H_;
  candidate.X_OH = translation(overrun_ * candidate.approach_O) * candidate.X_OH;
  candidate.approach_distance = approach_distance_ + overrun_;
  candidate.preshape = preshape_;
  if (!preshape_) {
    candidate.dofs = dofs_;
    candidate.joints = joints_;
  }
  std::vector<double> dofs = dofs_;
  for (std::size_t i = 0; i < free_dofs_.size(); ++i) {
    const DegreeOfFreedom& dof = hand_.dofs[free_dofs_[i]];
    double& value = dofs[free_dofs_[i]];
    value = std::clamp(value + reach_.spread * x[6 + i], dof.lower, dof.upper);
  }
  if (dofs != dofs_) {
    candidate.preshape.reset();
    candidate.dofs = std::move(dofs);
  }
  return candidate;
}

}  // namespace prehend
