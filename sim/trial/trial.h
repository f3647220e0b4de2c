// The result of a trial: what became of one candidate (run_trial.h).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/base/pose.h"
#include "sim/quality/contact.h"
#include "sim/quality/epsilon.h"
#include "sim/robot/dof_values.h"
#include "sim/scene/ids.h"
#include "sim/trial/outcome.h"

namespace prehend {

struct CompiledScene;

// A link of the hand and the body that it touches or collides with.
struct HandContact {
  LinkId link = {};
  BodyId body = BodyId::object();
};

// A contact of the grasp. The position [m] and the unit normal (into the object) of `point` are in
// the object's frame.
struct GraspContact {
  LinkId link = {};
  Contact point;
  double gap = 0.0;  // between link and object [m]
};

// Wall-clock time per stage of a trial [s]; 0 for a stage that did not run.
struct TrialSeconds {
  double reach = 0.0;     // inverse kinematics and collision checks of the arm
  double approach = 0.0;  // straight motion of the hand to the object
  double close = 0.0;     // closing, settling, contacts and quality
};

// The result of a trial. Where the trial ended early, the members of later stages are empty.
struct Trial {
  Outcome outcome = Outcome::no_contact;
  // The colliding link and body, for hand_blocked and approach_blocked.
  std::optional<HandContact> blocked;
  // For hand_blocked: how far the hand would have to move to overlap nothing (overlap_depth) [m].
  // None where that is farther than asked.
  std::optional<double> overlap;
  std::optional<ArmPair> arm_pair;  // the colliding pair, for arm_blocked
  Pose X_OH = Pose::Identity();     // of the hand's base in the grasp, or where the trial ended
  double travel = 0.0;              // length of the approach from the pre-grasp to X_OH [m]
  // By how much the hand was moved before it approached, in the object's frame, because it began in
  // an overlap small enough to be an error (resolve_overlap.h); X_OH contains it [m].
  Vector3 overlap_shift = Vector3::Zero();
  int back_offs = 0;  // how often the hand backed off before this grasp
  // Of self-centering fingers, of which one touched first: how far it pushed the object before the
  // other touched, as a move of the object relative to the hand, axes of O [m]. In the scene it may
  // be the hand that moved, the other way: X_OH contains that.
  Vector3 pushed = Vector3::Zero();
  // By how much the object turned, and its centre of mass moved, in the hand that closed on it
  // (settle.h) [rad, m].
  double turned = 0.0;
  double slid = 0.0;
  // Of a hand that closed in time: where the object C then is, in the frame O in which it stood.
  // X_OH and the contacts are relative to C. None: it stands where it stood.
  std::optional<Pose> X_OC;
  std::vector<double> dofs;    // final values of the hand's degrees of freedom [rad or m]
  std::vector<double> joints;  // final values of the hand's joints [rad or m]
  // With an arm that reached: its postures along the approach, from the pre-grasp to the grasp, the
  // hand at X_OH in the last one. Values of all degrees of freedom of the platform; those of the
  // hand are not used, it keeps its starting joints along the approach. Empty otherwise.
  std::vector<DofValues> arm_line;
  DofValues arm_dofs;  // the last posture of arm_line
  std::vector<GraspContact> contacts;
  EpsilonBracket epsilon;
  bool preferred = false;  // of a stable trial: all contacts are in preferred regions
  TrialSeconds seconds;    // the only part that is not the same in every run
};

// The pose of the hand's base in the grasp of `trial`, in the frame O in which the object stood.
Pose hand_in_scene(const Trial& trial);

// Names of the two bodies whose collision ended a trial; empty where none did.
struct CollisionNames {
  std::string link;  // of the hand or the arm
  std::string by;    // the object, an obstacle or another link
};
CollisionNames collision_of(const CompiledScene& scene, const Trial& trial);

}  // namespace prehend
