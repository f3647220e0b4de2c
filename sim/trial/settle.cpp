#include "sim/trial/settle.h"

#include <algorithm>
#include <optional>

#include "sim/base/index.h"
#include "sim/trial/self_centering.h"
#include "sim/trial/squeeze.h"

namespace prehend {
namespace {

// A step that does not bring the fingers closer is tried again with half the motion, down to this
// part of the largest one. Its angle then moves the surface, over the width of a finger, by less
// than contacts need to count as even (ContactOptions::evenness).
constexpr double kLeastPart = 3.5e-3;
// Fingers open by this before the object moves, so that they do not start inside it [m].
constexpr double kLoosen = 3e-3;
// Settling goes on while the fingers come closer by more than this in a step [m].
constexpr double kLeastGain = 1e-6;
// Forces of the fingers count as balanced when their sum is below this part of one of them, and
// the distance between their lines of action below kLeastArm [m].
constexpr double kLeastForce = 1e-2;
constexpr double kLeastArm = 1e-4;

// The first self-centering degree of freedom of the hand, where it has one.
std::optional<FingerPair> self_centering_fingers(const Robot& hand) {
  for (std::size_t d = 0; d < hand.dofs.size(); ++d) {
    if (hand.dofs[d].coupling == Coupling::self_centering) {
      return finger_pair(hand, static_cast<int>(d));
    }
  }
  return std::nullopt;
}

// Where the hand starts to close after a motion: with fingers a little open, because at their
// present opening the motion would push them into the object.
void set_closing_start(const DegreeOfFreedom& dof, const FingerPair& fingers, const Trial& trial,
                       const Pose& X_OH, ClosingStart& start) {
  start.X_OH = X_OH;
  start.dofs = trial.dofs;
  double& opening = start.dofs[index(fingers.dof)];
  opening += dof.closing_velocity < 0.0 ? std::min(kLoosen, dof.upper - opening)
                                        : -std::min(kLoosen, opening - dof.lower);
}

// Whether the fingers of `next` are closer together than those of `trial`. That is the criterion of
// a motion that really happens: a squeezed object moves so that the fingers yield to their drive,
// and a motion that pushes them apart would need work from outside.
bool is_closer(const DegreeOfFreedom& dof, const FingerPair& fingers, const Trial& trial,
               const Trial& next) {
  const double change = trial.joints[index(fingers.first)] - next.joints[index(fingers.first)];
  return (dof.closing_velocity < 0.0 ? change : -change) > kLeastGain;
}

// One grasp that settles.
class Settling {
 public:
  Settling(const CompiledScene& scene, const FingerPair& fingers, const TrialOptions& options,
           SettleWorkspace& workspace, GraspWorkspace& grasping, const RunContext& context)
      : scene_(scene),
        fingers_(fingers),
        options_(options),
        workspace_(workspace),
        grasping_(grasping),
        context_(context) {}

  void run(Trial& trial) {
    Trial& now = workspace_.now;
    now = trial;
    workspace_.room.start(scene_, trial, options_);
    // Part of the largest motion of a step that is tried. It stays halved: the object comes to rest
    // with ever smaller motions.
    double part = 1.0;
    for (int k = 0;
         k < options_.settle.steps && part >= kLeastPart && now.outcome != Outcome::stable; ++k) {
      if (step(now, part, workspace_.next)) {
        now = workspace_.next;
      } else {
        part *= 0.5;
      }
    }
    if (now.outcome != Outcome::stable) return;
    // The whole motion, from first pose to last: steps in different directions do not add up.
    now.turned = Eigen::AngleAxisd(trial.X_OH.linear().transpose() * now.X_OH.linear()).angle();
    now.pushed = trial.pushed;
    const Vector3& center_O = scene_.scene.object.center_of_mass;
    now.slid = (trial.X_OH.inverse() * center_O - now.X_OH.inverse() * center_O).norm();
    trial = now;
  }

 private:
  // `next`: the trial after the object has moved by this part of a step and the hand has closed
  // again. False where an obstacle is in the way, the hand collides, a finger loses contact, or the
  // fingers do not come closer (the object would not move that far).
  bool step(const Trial& trial, double part, Trial& next) {
    const std::optional<ObjectMotion> motion = squeezed(scene_, fingers_, trial, limits(part));
    if (!motion) return false;
    const DegreeOfFreedom& dof = scene_.scene.hand.dofs[index(fingers_.dof)];
    ClosingStart& start = workspace_.start;
    set_closing_start(dof, fingers_, trial, after(*motion, trial.X_OH), start);
    // The room is checked before the hand closes, which takes much longer, and again afterwards,
    // when it is known how far the fingers and the hand have moved.
    HandTurn& turn = workspace_.turn;
    turn.middle_O = motion->center_O;
    turn.angle = motion->angular_O.norm();
    turn.slide = motion->linear_O.norm();
    joint_values(scene_.scene.hand, start.dofs, turn.opened);
    turn.closed = turn.opened;
    turn.shift = 0.0;
    if (!workspace_.room.allows(trial, turn)) return false;
    if (hand_collision(scene_, start.X_OH, turn.opened, grasping_.collision)) return false;
    next = trial;
    close_and_score(scene_, start, options_, grasping_, next, context_);
    const bool touches =
        next.outcome == Outcome::stable || next.outcome == Outcome::not_force_closure;
    const bool settles = is_closer(dof, fingers_, trial, next) || next.outcome == Outcome::stable;
    if (!touches || !settles) return false;
    turn.closed = next.joints;
    turn.shift = (next.X_OH.translation() - start.X_OH.translation()).norm();
    if (!workspace_.room.allows(trial, turn)) return false;
    workspace_.room.consume(trial, turn);
    return true;
  }

  SqueezeLimits limits(double part) const {
    const SettleOptions& settle = options_.settle;
    return {part * settle.slide, part * settle.angle, kLeastForce, kLeastArm};
  }

  const CompiledScene& scene_;
  const FingerPair& fingers_;
  const TrialOptions& options_;
  SettleWorkspace& workspace_;
  GraspWorkspace& grasping_;
  const RunContext& context_;
};

}  // namespace

void settle(const CompiledScene& scene, const TrialOptions& options, SettleWorkspace& workspace,
            GraspWorkspace& grasping, Trial& trial, const RunContext& context) {
  if (trial.outcome != Outcome::not_force_closure || options.settle.steps <= 0) return;
  // With an arm the object would have to leave its pose in the world (settle.h).
  if (scene.arm) return;
  const std::optional<FingerPair> fingers = self_centering_fingers(scene.scene.hand);
  if (!fingers) return;
  Settling(scene, *fingers, options, workspace, grasping, context).run(trial);
}

}  // namespace prehend
