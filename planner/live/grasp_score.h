// What is said of a hand where it is: what it touches, how well that holds, and what it is inside
// of. Nothing is moved.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/quality/forces.h"
#include "sim/quality/wrench_slice.h"
#include "sim/quality/wrench_space.h"
#include "sim/scene/compiled_arm.h"
#include "sim/scene/compiled_scene.h"
#include "sim/trial/trial.h"
#include "sim/trial/trial_options.h"

namespace prehend {

// How well the object is held, and what limits that.
struct GraspScore {
  Outcome outcome = Outcome::no_contact;  // no_contact, not_force_closure or stable
  std::vector<GraspContact> contacts;
  EpsilonBracket epsilon;
  double volume = 0.0;  // of the hull of the contact wrenches; 0 without force closure
  // The link whose contacts the grasp needs most, and epsilon (lower bound) without them: the
  // smallest of all links, of equal ones the first. Empty without force closure.
  std::string limiting_link;
  double epsilon_without = 0.0;
  // Of the wrench space; empty where it is flat, or nobody asked for them.
  WrenchSections sections;
  WrenchSlice chosen;  // the one of JudgeOptions::fixed; empty also without it
};

// How contacts are judged while somebody looks at them.
struct JudgeOptions {
  WrenchNorm norm = WrenchNorm::l1;
  int edges = 8;  // of the pyramids that stand for friction cones, in kJudgedEdges
  // Of a section of the wrench space besides those without torque and without force.
  std::optional<FixedCoordinates> fixed = {};

  bool operator==(const JudgeOptions& other) const;
};

// More edges than these would make one wait.
inline constexpr Range kJudgedEdges{.lower = 3.0, .upper = 64.0};

// Epsilon as score_contacts (close_and_score.h), of the contacts with the trial's X_OH and joints,
// where `judge` asks for the L1 norm, else as grasp_epsilon with forces of at most one. `sections`:
// whether to fill them in.
GraspScore judge_grasp_of(const CompiledScene& scene, const Trial& trial, TrialOptions options,
                          const JudgeOptions& judge = {}, bool sections = false);

// The smallest forces at the contacts of the trial that balance a load on the object: a force [N]
// at the origin of torques, which is the object's centre of mass, and a torque about it [N m], both
// in the object's frame. `joint_limits`: within the efforts of the hand's drives.
ContactForces forces_for(const CompiledScene& scene, const Trial& trial, const Vector3& force_O,
                         const Vector3& torque_O, bool joint_limits);

// Two bodies that overlap, one of them a link of the hand.
struct Overlap {
  std::string link;
  std::string by;  // the object, an obstacle, or another link
};

// All of them: link after link with the object and the obstacles, then pairs of links.
std::vector<Overlap> overlaps_of(const CompiledScene& scene, const Pose& X_OH,
                                 const std::vector<double>& joints);

// The same of the pairs of the arm (CompiledArm::arm_pairs), whose links have the names of their
// robots before their own. `joints`: of all of the platform [rad or m].
std::vector<Overlap> arm_overlaps(const CompiledArm& arm, const std::vector<double>& joints);

}  // namespace prehend
