// What plan() and evaluate() return.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "planner/plan/advice.h"
#include "planner/plan/path/lift_object.h"
#include "primitives/decompose.h"
#include "sim/base/named_enum.h"
#include "sim/base/run_context.h"
#include "sim/manipulation/shake_report.h"
#include "sim/motion/control/trajectory.h"
#include "sim/quality/interval.h"
#include "sim/quality/wrench_slice.h"
#include "sim/shape/primitive.h"
#include "sim/trial/candidate.h"
#include "sim/trial/pad_patches.h"
#include "sim/trial/payload_margin.h"
#include "sim/trial/robustness.h"
#include "sim/trial/trial.h"

namespace prehend {

// Where a grasp came from that refine_grasps found.
struct Refinement {
  int parent = 0;     // index into PlanResult::tried of the grasp that was refined
  double gain = 0.0;  // by how much its objective is larger than the parent's
  int trials = 0;     // that were made for it
};

// On which shapes of an object that was completed (Completion) a grasp holds.
struct HeldShapes {
  bool likely = false;
  std::optional<bool> thin = {};  // none: not tried
  std::optional<bool> thick = {};
  double unseen = 0.0;  // part of the hand's way that no camera saw to be free: try_shapes
  // How firmly it holds on all of them, and with the hand a little beside: try_shapes.
  double certainty = 0.0;

  int held() const { return int{likely} + int{thin.value_or(false)} + int{thick.value_or(false)}; }
  int tried() const { return 1 + int{thin.has_value()} + int{thick.has_value()}; }
};

// A grasp with its quality and where it came from.
struct ScoredGrasp {
  Trial trial;          // pose, joints, contacts and epsilon that the trial found
  Candidate candidate;  // what was tried
  // Volume of the convex hull of contact wrenches (6-D, torques scaled); 0 without force closure,
  // nothing where it was not asked for or the call was cancelled before it was computed.
  std::optional<double> volume = {};
  std::optional<int> primitive =
      {};                 // index into PlanResult::primitives; none: given by the caller
  std::string rule = {};  // rule that proposed it, or "given"
  std::optional<Trajectory> path = {};
  std::optional<WrenchSections> sections = {};
  int tried = 0;  // index into PlanResult::tried
  // Of a stable grasp: the least and the largest epsilon with the hand moved by next to nothing
  // (epsilon_nearby). Computed with the volume.
  std::optional<Interval> epsilon_nearby = {};
  // Of a grasp with contacts: what its weight takes (payload_margin). Computed with the volume.
  std::optional<PayloadMargin> holding = {};
  std::optional<HeldByPads> pads = {};  // where contacts are finite elements
  // Of a grasp with contacts, where it was asked for: how it fares on disturbed poses.
  std::optional<Robustness> robustness = {};
  std::optional<Refinement> refinement = {};
  // The same grasp on an object that is free to move while the hand closes: X_OC says where that
  // ends, contacts and epsilon are of there. Only of those that were asked (free_grasps).
  std::optional<Trial> free = {};
  std::optional<ShakeReport> shake = {};  // filled in by shake_grasps
  std::optional<HeldShapes> shapes = {};  // of an object that was completed: try_shapes
  LiftEnd lift = LiftEnd::not_asked;      // whether `path` goes on after the grasp, or why not
};

// A candidate that was tried, and the outcome of its trial.
struct Tried {
  int candidate = 0;                      // index into the candidates that were proposed or given
  Pose X_OH = Pose::Identity();           // hand pose at which its approach was to end
  Vector3 approach_O = Vector3::UnitZ();  // unit
  Outcome outcome = Outcome::no_contact;
  CollisionNames
      collision_of;  // which link collided with what; empty for outcomes without a collision
};

// How many candidates ended in `outcome` because `link` collided with `by`.
struct CollisionCount {
  Outcome outcome = Outcome::hand_blocked;
  std::string link;
  std::string by;  // the object, an obstacle, or another link
  int count = 0;
};

// What PlanResult::stages counts, from primitives to grasps.
enum class PlanCount {
  primitives_given,  // by the scene
  primitives,        // found in the object's mesh
  candidates,        // proposed
  reach,             // tried candidates that the arm can reach without collision
  obstacles,         // in the scene
  trials,            // candidates that were tried
  refined,           // grasps that a refinement made better
  ranked,            // stable grasps, without near-identical ones
  paths              // ranked grasps for which a path was found
};

// "primitives", "candidates", ...: names of the stages in output for people and in files.
constexpr auto enum_names(PlanCount /*of*/) {
  return std::to_array<std::string_view>({"primitives given", "primitives", "candidates", "reach",
                                          "obstacles", "trials", "refined", "ranked", "paths"});
}

// One count of PlanResult::stages.
struct StageCount {
  PlanCount what = PlanCount::primitives;
  int count = 0;
};

// How a call of plan() or evaluate() with valid arguments ended.
enum class PlanStatus {
  complete,
  out_of_time,       // the deadline passed before all was done; what was found is there
  cancelled,         // the context was cancelled before all was done; what was found is there
  object_too_large,  // every width that a rule closes on exceeds what the hand opens to: see
                     // PlanResult::smallest_width and largest_opening
  no_candidates      // there was no candidate for another reason
};

// "complete", "cancelled", ...: as in files.
constexpr auto enum_names(PlanStatus /*of*/) {
  return std::to_array<std::string_view>(
      {"complete", "out_of_time", "cancelled", "object_too_large", "no_candidates"});
}

// What plan() and evaluate() return.
struct PlanResult {
  PlanStatus status = PlanStatus::complete;
  // How many of the trials that were asked for (SearchOptions::trials, or the candidates given)
  // were not made: 0 unless the call was cancelled or ran out of time, or plan() had nothing left
  // to propose.
  int untested = 0;
  // Of plan(): ways to grasp (ProposalSequence), and how many of them no trial has looked at.
  int families = 0;
  int families_untested = 0;
  // Of plan(): the smallest width that a rule closes on (infinite where there was no rule at all),
  // and the largest width that a preshape of the hand takes [m].
  double smallest_width = 0.0;
  double largest_opening = 0.0;
  std::vector<Primitive> primitives;
  // Of plan(): how far the object's surface is from its solids, which stand first in `primitives`.
  // None where the scene states the primitives, or they were read from a file.
  std::optional<Decomposition> solids = {};
  std::vector<ScoredGrasp> grasps;       // plan: best first; evaluate: in the given order
  std::vector<Tried> tried;              // finished trials, in the order of candidates
  EnumArray<Outcome, int> outcomes;      // number of trials with each Outcome
  std::vector<CollisionCount> blockers;  // those with the most candidates first
  // Of plan() without a grasp, unless cancelled: how the candidates of each rule ended, in the
  // order in which the rules were first proposed, and what may help. Empty where there are grasps.
  std::vector<RuleCount> rules;
  std::vector<Advice> advice;
  std::vector<StageCount> stages;  // in the order of the stages
  std::vector<StageTime> times;    // wall-clock time of each stage
  TrialSeconds trial_seconds;      // of all trials, on all threads together
};

// Counts `blockers` from `tried`; equal counts in the order of outcome, link and body.
void count_blockers(PlanResult& result);

}  // namespace prehend
