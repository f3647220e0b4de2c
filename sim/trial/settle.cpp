#include "sim/trial/settle.h"

#include <algorithm>
#include <optional>

#include "sim/base/index.h"
#include "sim/trial/self_centering.h"

namespace prehend {
namespace {

// The first self-centering degree of freedom of the hand, where it has one.
std::optional<FingerPair> self_centering_fingers(const Robot& hand) {
  for (std::size_t d = 0; d < hand.dofs.size(); ++d) {
    if (hand.dofs[d].coupling == Coupling::self_centering) {
      return finger_pair(hand, static_cast<int>(d));
    }
  }
  return std::nullopt;
}

// Where a finger presses: the mean position of the contacts of all links beyond its joint, in O.
std::optional<Vector3> touched_by(const CompiledScene& scene, const Trial& trial, int joint) {
  Vector3 sum = Vector3::Zero();
  int count = 0;
  for (const GraspContact& contact : trial.contacts) {
    const std::vector<int>& joints = scene.links[index(contact.link)].joints;
    if (std::find(joints.begin(), joints.end(), joint) == joints.end()) continue;
    sum += contact.point.position;
    ++count;
  }
  if (count == 0) return std::nullopt;
  return sum / count;
}

// The axis about which the two fingers turn the object. They press with opposite forces along the
// opening axis, at points a and b. Unless a - b is parallel to that axis, the forces are a couple
// of the moment (a - b) x axis per unit of force, whose length is the distance between their lines
// of action.
struct Couple {
  Vector3 middle_O;  // between the fingers
  Vector3 axis_O;    // unit
};

std::optional<Couple> couple_of(const CompiledScene& scene, const FingerPair& fingers,
                                const SettleOptions& options, const Trial& trial) {
  const std::optional<Vector3> a = touched_by(scene, trial, fingers.first);
  const std::optional<Vector3> b = touched_by(scene, trial, fingers.second);
  if (!a || !b) return std::nullopt;
  const Vector3 opening_O =
      trial.X_OH.linear() * opening_axis(scene.scene.hand, fingers, trial.joints);
  // The force on the object at `a` is along -opening_O, so its couple is the negative of this one:
  // the object turns the negative way in the hand, and the hand the positive way about the object.
  const Vector3 couple = (*a - *b).cross(opening_O);
  if (couple.norm() < options.least_arm) return std::nullopt;
  return Couple{0.5 * (*a + *b), couple.normalized()};
}

// The hand's pose after it turned about the object, which is the same relative motion as the object
// turning the other way in the hand.
Pose turned(const Couple& couple, double angle, const Pose& X_OH) {
  return translation(couple.middle_O) * Eigen::AngleAxisd(angle, couple.axis_O) *
         translation(-couple.middle_O) * X_OH;
}

// Where the hand starts to close after a turn: with fingers a little open, because at their present
// opening the turn would push them into the object.
void set_closing_start(const DegreeOfFreedom& dof, const FingerPair& fingers,
                       const SettleOptions& options, const Trial& trial, const Pose& X_OH,
                       ClosingStart& start) {
  start.X_OH = X_OH;
  start.dofs = trial.dofs;
  double& opening = start.dofs[index(fingers.dof)];
  opening += dof.closing_velocity < 0.0 ? std::min(options.loosen, dof.upper - opening)
                                        : -std::min(options.loosen, opening - dof.lower);
}

// Whether the fingers of `next` are closer together than those of `trial`. That is the criterion of
// a turn that really happens: a squeezed object moves so that the fingers yield to their drive, and
// a turn that pushes them apart would need work from outside.
bool is_closer(const DegreeOfFreedom& dof, const FingerPair& fingers, const SettleOptions& options,
               const Trial& trial, const Trial& next) {
  const double change = trial.joints[index(fingers.first)] - next.joints[index(fingers.first)];
  return (dof.closing_velocity < 0.0 ? change : -change) > options.least_gain;
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
    double angle = options_.settle.angle;
    for (int k = 0; k < options_.settle.steps && angle >= options_.settle.least_angle &&
                    now.outcome != Outcome::stable;
         ++k) {
      if (step(now, angle, workspace_.next)) {
        now = workspace_.next;
      } else {
        // The angle stays halved: the object comes to rest with ever smaller turns.
        angle *= 0.5;
      }
    }
    if (now.outcome != Outcome::stable) return;
    // The whole turn, from first pose to last: steps about different axes do not simply add up.
    now.turned = Eigen::AngleAxisd(trial.X_OH.linear().transpose() * now.X_OH.linear()).angle();
    trial = now;
  }

 private:
  // `next`: the trial after the hand has turned by `angle` and closed again. False where an
  // obstacle is in the way, the hand collides, a finger loses contact, or the fingers do not come
  // closer (the object would not turn that far).
  bool step(const Trial& trial, double angle, Trial& next) {
    const std::optional<Couple> couple = couple_of(scene_, fingers_, options_.settle, trial);
    if (!couple) return false;
    const DegreeOfFreedom& dof = scene_.scene.hand.dofs[index(fingers_.dof)];
    ClosingStart& start = workspace_.start;
    set_closing_start(dof, fingers_, options_.settle, trial, turned(*couple, angle, trial.X_OH),
                      start);
    // The room is checked before the hand closes, which takes much longer, and again afterwards,
    // when it is known how far the fingers and the hand have moved.
    HandTurn& turn = workspace_.turn;
    turn.middle_O = couple->middle_O;
    turn.angle = angle;
    joint_values(scene_.scene.hand, start.dofs, turn.opened);
    turn.closed = turn.opened;
    turn.shift = 0.0;
    if (!workspace_.room.allows(trial, turn)) return false;
    if (hand_collision(scene_, start.X_OH, turn.opened, grasping_.collision)) return false;
    next = trial;
    grasp_at(scene_, start, options_, grasping_, next, context_);
    const bool touches =
        next.outcome == Outcome::stable || next.outcome == Outcome::not_force_closure;
    const bool settles =
        is_closer(dof, fingers_, options_.settle, trial, next) || next.outcome == Outcome::stable;
    if (!touches || !settles) return false;
    turn.closed = next.joints;
    turn.shift = (next.X_OH.translation() - start.X_OH.translation()).norm();
    if (!workspace_.room.allows(trial, turn)) return false;
    workspace_.room.spend(trial, turn);
    return true;
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
