// One candidate, from pre-grasp to quality: a pure function of scene, candidate and options.
#pragma once

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

struct Candidate {
  Pose X_OH = Pose::Identity();  // the hand's base where the approach ends if nothing is touched
  Vector3 approach_O = Vector3::UnitZ();  // unit, object frame
  double approach_distance = 0.0;         // from the pre-grasp to X_OH, 0: the hand is there [m]
  std::optional<int> preshape;            // index into the hand's preshapes; none: `dofs`
  std::vector<double> dofs;               // where the hand starts without a preshape
  std::vector<double> joints;             // used with `dofs`; empty: as the dofs say
};

// A contact of the grasp; position and normal (into the object) in the object's frame.
struct GraspContact {
  LinkId link = {};
  Contact point;
  double gap = 0.0;  // between link and object [m]
};

// Where the time of a trial went [s]; 0 for a stage that the scene does not need.
struct TrialSeconds {
  double reach = 0.0;
  double approach = 0.0;
  double close = 0.0;  // with contacts and quality
};

struct Trial {
  Outcome outcome = Outcome::no_contact;
  std::optional<HandContact> blocked;  // what met, for hand_blocked and approach_blocked
  std::optional<ArmPair> arm_pair;     // what met, for arm_blocked
  Pose X_OH = Pose::Identity();        // of the grasp
  double travel = 0.0;                 // of the approach until the grasp [m]
  int back_offs = 0;
  double turned = 0.0;  // by this the object turned between the fingers, see settle.h [rad]
  std::vector<double> dofs;
  std::vector<double> joints;
  // With an arm that reached: its postures along the approach, from the pre-grasp to the grasp, the
  // hand at X_OH in the last one. Values of all degrees of freedom of the platform; those of the
  // hand are not used, it keeps its starting joints along the approach. Empty otherwise.
  std::vector<DofValues> arm_line;
  DofValues arm_dofs;  // the last posture of arm_line
  std::vector<GraspContact> contacts;
  EpsilonBracket epsilon;
  TrialSeconds seconds;  // the only part that is not the same in every run
};

// Names of the link that was blocked and of what blocked it; empty for other outcomes.
struct Blame {
  std::string link;
  std::string by;
};
Blame blame(const CompiledScene& scene, const Trial& trial);

// The straight motion of the hand from the pre-grasp to the grasp, its joints where the candidate
// starts.
HandLine approach_line(const CompiledScene& scene, const Candidate& candidate, const Trial& trial);

// A scene with an arm also has it reach: see find_reach. Throws Cancelled.
Trial run_trial(const CompiledScene& scene, const Candidate& candidate,
                const TrialOptions& options = {}, const RunContext& context = {});

// All contacts between the hand and the object, links in order.
std::vector<GraspContact> grasp_contacts(const CompiledScene& scene, const Pose& X_OH,
                                         const std::vector<double>& joints,
                                         const TrialOptions& options);

// What the quality measures take.
std::vector<Contact> contacts_of(const std::vector<GraspContact>& contacts);

}  // namespace prehend
