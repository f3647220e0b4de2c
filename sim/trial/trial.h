// A grasp trial: one candidate is carried out from the pre-grasp to the closed hand, and the
// quality of the grasp is computed. A pure function of scene, candidate and options.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/base/run_context.h"
#include "sim/quality/contact.h"
#include "sim/quality/epsilon.h"
#include "sim/scene/compiled_scene.h"
#include "sim/trial/hand_collision.h"
#include "sim/trial/outcome.h"
#include "sim/trial/trial_options.h"

namespace prehend {

// A grasp to try: where the hand goes, from which direction, and with which opening it starts.
struct Candidate {
  // Pose of the hand's base at the end of an approach that touches nothing.
  Pose X_OH = Pose::Identity();
  Vector3 approach_O = Vector3::UnitZ();  // direction in which the hand moves, unit, object frame
  double approach_distance = 0.0;         // from the pre-grasp to X_OH; 0: no approach [m]
  std::optional<int> preshape;            // index into Hand::preshapes; none: `dofs` is used
  // Without a preshape, the start values of the hand's degrees of freedom [rad or m].
  std::vector<double> dofs;
  // With `dofs`, the start values of the joints [rad or m]; empty: joint_values of `dofs`.
  std::vector<double> joints;
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
  TrialSeconds seconds;  // the only part that is not the same in every run
};

// The pose of the hand's base in the grasp of `trial`, in the frame O in which the object stood.
Pose hand_in_scene(const Trial& trial);

// Names of the two bodies whose collision ended a trial; empty where none did.
struct CollisionNames {
  std::string link;  // of the hand or the arm
  std::string by;    // the object, an obstacle or another link
};
CollisionNames collision_of(const CompiledScene& scene, const Trial& trial);

// The straight motion of the hand from the pre-grasp to the grasp of `trial`, with the joint values
// at which the candidate starts.
HandLine approach_line(const CompiledScene& scene, const Candidate& candidate, const Trial& trial);

// Carries out `candidate`: the hand approaches until it touches the object, closes and is centred,
// an object that is not held may settle (settle.h), and the contacts are judged by epsilon in the
// L1 wrench space. A grasp that does not hold is tried again up to options.back_off_tries times
// with the hand backed off along the approach; only a stable grasp replaces the first. In a scene
// with an arm, the arm must also follow the approach without a collision (find_reach).
//
// `candidate` must fit the hand: a preshape in range, or one value per degree of freedom (and per
// joint, where given). Throws Cancelled.
Trial run_trial(const CompiledScene& scene, const Candidate& candidate,
                const TrialOptions& options = {}, const RunContext& context = {});

// The memory that trials need besides their results: one for each thread, for any number of trials
// of any scenes. It grows to what the largest trial needs; from then on the trials of a free hand
// do not allocate, except in the rare case in which rounding stalls epsilon and qhull has to help
// (epsilon_l1). Inverse kinematics and the checks of an arm do allocate. Trials leave nothing in it
// that the next one could depend on.
class TrialWorkspace {
 public:
  TrialWorkspace();
  ~TrialWorkspace();
  TrialWorkspace(TrialWorkspace&& other) noexcept;
  TrialWorkspace& operator=(TrialWorkspace&& other) noexcept;

  // Internal, for run_trial.
  struct Buffers;
  Buffers& buffers() { return *buffers_; }

 private:
  std::unique_ptr<Buffers> buffers_;
};

// As run_trial above, in the memory of `workspace` and of `trial`, which is replaced. After
// Cancelled, `trial` means nothing. The context has no default, since making one allocates.
void run_trial(const CompiledScene& scene, const Candidate& candidate, const TrialOptions& options,
               TrialWorkspace& workspace, Trial& trial, const RunContext& context);

// The same without asking the arm, where there is one, whether it follows.
void run_hand_trial(const CompiledScene& scene, const Candidate& candidate,
                    const TrialOptions& options, TrialWorkspace& workspace, Trial& trial,
                    const RunContext& context);

// All contacts between hand and object with the hand's base at X_OH and its joints at `joints`,
// ordered by link: hard point contacts with friction, then, for compliant links and with
// options.soft_fingers, patches with torsional friction.
std::vector<GraspContact> grasp_contacts(const CompiledScene& scene, const Pose& X_OH,
                                         const std::vector<double>& joints,
                                         const TrialOptions& options);

// The contacts without link and gap, as the quality measures take them (sim/quality).
std::vector<Contact> contacts_of(const std::vector<GraspContact>& contacts);

}  // namespace prehend
