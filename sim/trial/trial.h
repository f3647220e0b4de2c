// One candidate, from pre-grasp to quality: a pure function of scene, candidate and options.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/base/run_context.h"
#include "sim/quality/contact.h"
#include "sim/quality/epsilon.h"
#include "sim/scene/compiled_scene.h"
#include "sim/trial/outcome.h"
#include "sim/trial/trial_options.h"

namespace prehend {

struct Candidate {
  Pose X_OH = Pose::Identity();  // the hand's base where the approach ends if nothing is touched
  Vector3 approach_O = Vector3::UnitZ();  // unit, object frame
  double approach_distance = 0.0;         // from the pre-grasp to X_OH, 0: the hand is there [m]
  int preshape = -1;                      // index into the hand's preshapes, -1: `dofs`
  std::vector<double> dofs;               // used when preshape is -1
  std::vector<double> joints;             // used when preshape is -1; empty: as the dofs say
};

// A contact of the grasp; position and normal (into the object) in the object's frame.
struct GraspContact {
  int link = 0;
  Contact point;
  double gap = 0.0;  // between link and object [m]
};

// Where the time of a trial went; a stage that the scene does not ask for took none.
struct TrialSeconds {
  double reach = 0.0;
  double approach = 0.0;
  double close = 0.0;  // with contacts and quality
};

struct Trial {
  Outcome outcome = Outcome::no_contact;
  int link = -1;                    // that was blocked, for hand_blocked and approach_blocked
  int obstacle = -1;                // that blocked it, -1: the object
  std::optional<ArmPair> arm_pair;  // what met, for arm_blocked
  Pose X_OH = Pose::Identity();     // of the grasp
  double travel = 0.0;              // of the approach until the grasp [m]
  int back_offs = 0;
  double turned = 0.0;  // by this the object turned between the fingers, see settle.h [rad]
  std::vector<double> dofs;
  std::vector<double> joints;
  std::vector<double> arm_dofs;  // of the platform, the hand as it starts; empty without an arm
  std::vector<GraspContact> contacts;
  EpsilonBracket epsilon;
  TrialSeconds seconds;  // the only part that is not the same in every run
};

// What was blocked, and by what; empty for other outcomes.
struct Blame {
  std::string link;
  std::string by;
};
Blame blame(const CompiledScene& scene, const Trial& trial);

// The way of the hand from the pre-grasp to the grasp, with its joints as the candidate says.
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
