#include "sim/trial/settle.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "sim/base/index.h"
#include "sim/trial/grasp_at.h"
#include "sim/trial/self_centering.h"

namespace prehend {
namespace {

// Fingers open by this before the object turns, so that it can [m].
constexpr double kLoosen = 3e-3;
// Turning goes on while the fingers come closer by more than this in a step [m].
constexpr double kCloser = 1e-6;
// Couples with an arm shorter than this do not turn anything [m].
constexpr double kShortArm = 1e-4;

std::optional<FingerPair> self_centering_fingers(const Robot& hand) {
  for (std::size_t d = 0; d < hand.dofs.size(); ++d) {
    if (hand.dofs[d].coupling == Coupling::self_centering) {
      return finger_pair(hand, static_cast<int>(d));
    }
  }
  return std::nullopt;
}

// The middle of what the links after a joint touch, in O.
std::optional<Vector3> touched_by(const CompiledScene& scene, const Trial& trial, int joint) {
  Vector3 sum = Vector3::Zero();
  int count = 0;
  for (const GraspContact& contact : trial.contacts) {
    const std::vector<int>& joints = scene.links[index(contact.link)].joints;
    if (joints.empty() || joints.back() != joint) continue;
    sum += contact.point.position;
    ++count;
  }
  if (count == 0) return std::nullopt;
  return sum / count;
}

// The hand turned about the middle between the fingers, as far as the couple of their squeeze turns
// the object the other way.
std::optional<Pose> turned(const CompiledScene& scene, const FingerPair& fingers,
                           const Trial& trial, double angle) {
  const std::optional<Vector3> a = touched_by(scene, trial, fingers.first);
  const std::optional<Vector3> b = touched_by(scene, trial, fingers.second);
  if (!a || !b) return std::nullopt;
  const Vector3 opening_O = trial.X_OH.linear() * fingers.opening_H;
  const Vector3 couple = (*a - *b).cross(opening_O);
  if (couple.norm() < kShortArm) return std::nullopt;
  const Vector3 middle = 0.5 * (*a + *b);
  return translation(middle) * Eigen::AngleAxisd(angle, couple.normalized()) *
         translation(-middle) * trial.X_OH;
}

std::optional<Trial> step(const CompiledScene& scene, const FingerPair& fingers,
                          const TrialOptions& options, const Trial& trial, double angle,
                          const RunContext& context) {
  const std::optional<Pose> X_OH = turned(scene, fingers, trial, angle);
  if (!X_OH) return std::nullopt;
  const DegreeOfFreedom& dof = scene.scene.hand.dofs[index(fingers.dof)];
  ClosingStart start;
  start.X_OH = *X_OH;
  start.dofs = trial.dofs;
  double& opening = start.dofs[index(fingers.dof)];
  opening += dof.closing_velocity < 0.0 ? std::min(kLoosen, dof.upper - opening)
                                        : -std::min(kLoosen, opening - dof.lower);
  int obstacle = -1;
  if (colliding_link(scene, start.X_OH, joint_values(scene.scene.hand, start.dofs), obstacle) >=
      0) {
    return std::nullopt;
  }
  Trial next = trial;
  grasp_at(scene, start, options, next, context);
  const bool touches =
      next.outcome == Outcome::stable || next.outcome == Outcome::not_force_closure;
  const double width = next.joints[index(fingers.first)];
  const bool closer =
      (trial.joints[index(fingers.first)] - width) * (dof.closing_velocity < 0.0 ? 1.0 : -1.0) >
      kCloser;
  if (!touches || !(closer || next.outcome == Outcome::stable)) return std::nullopt;
  return next;
}

}  // namespace

void settle(const CompiledScene& scene, const TrialOptions& options, Trial& trial,
            const RunContext& context) {
  if (trial.outcome != Outcome::not_force_closure || options.settle_steps <= 0) return;
  if (scene.has_obstacles() || scene.arm) return;
  const std::optional<FingerPair> fingers = self_centering_fingers(scene.scene.hand);
  if (!fingers) return;
  Trial now = trial;
  double angle = options.settle_angle;
  for (int k = 0; k < options.settle_steps && now.outcome != Outcome::stable; ++k) {
    if (std::optional<Trial> next = step(scene, *fingers, options, now, angle, context)) {
      now = std::move(*next);
    } else {
      angle *= 0.5;
    }
  }
  if (now.outcome != Outcome::stable) return;
  now.turned = Eigen::AngleAxisd(trial.X_OH.linear().transpose() * now.X_OH.linear()).angle();
  trial = std::move(now);
}

}  // namespace prehend
