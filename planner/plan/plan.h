// Planning: from a scene to ranked grasps. Evaluation: from given grasps to their scores.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "planner/plan/advice.h"
#include "planner/plan/path/grasp_path.h"
#include "planner/plan/propose/candidates.h"
#include "planner/plan/rank.h"
#include "planner/plan/refine_grasps.h"
#include "planner/plan/search_grasps.h"
#include "planner/plan/stopwatch.h"
#include "primitives/decompose.h"
#include "primitives/thin_parts.h"
#include "sim/base/run_context.h"
#include "sim/base/settings.h"
#include "sim/manipulation/shake.h"
#include "sim/quality/interval.h"
#include "sim/quality/wrench_slice.h"
#include "sim/scene/compiled_scene.h"
#include "sim/trial/payload_margin.h"
#include "sim/trial/perturbed_trials.h"
#include "sim/trial/trial.h"

namespace prehend {

// Options of every stage of plan().
struct PlanOptions {
  // Everything random in the plan derives from it (random.h): seeds in the options below are set
  // from it, whatever they are.
  std::uint64_t seed = 1;
  DecomposeOptions primitives;
  ThinPartOptions thin_parts;
  CandidateOptions candidates;
  SearchOptions search;
  TrialOptions trial;
  // The best grasps of the search are improved by at most two fifths of the trials that it made;
  // those that gain less than 1 % of their epsilon are left out.
  RefineOptions refine;
  RankOptions rank;
  // Set: a path of the arm is planned for each grasp, and grasps without a path are left out. Needs
  // a scene with an arm.
  std::optional<GraspPathOptions> paths;
  // Whether the returned grasps are tried again with errors of pose, friction and centre of mass,
  // and how large these are.
  bool robustness = false;
  UncertaintyOptions uncertainty;
  // Whether the volume, epsilon_nearby and the holding of the returned grasps are computed, which
  // takes longer than the trials of all of them.
  bool volumes = true;
  // For how many of the returned grasps, the first ones, sections of the wrench space are computed,
  // with their volumes.
  std::size_t sections = 0;
};

// The settings that the grasps depend on. Those of the paths are visited through GraspPathOptions,
// where there are any.
template <SettingsOf<PlanOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [seed, primitives, thin_parts, candidates, search, trial, refine, rank, paths, robustness,
         uncertainty, volumes, sections] = options;
  visit("seed", seed, kAtLeast0);
  visit("", primitives);
  visit("", thin_parts);
  visit("", candidates);
  visit("", search);
  visit("", trial);
  visit("refine", refine);
  visit("", rank);
  visit("robustness", robustness);
  visit("uncertainty", uncertainty);
  visit("volumes", volumes);
}

// Options of evaluate().
struct EvaluateOptions {
  std::uint64_t seed = 1;  // as in PlanOptions
  TrialOptions trial;
  bool robustness = false;         // as in PlanOptions
  UncertaintyOptions uncertainty;  // as in PlanOptions
  // For how many of the grasps, the first ones, the volume, epsilon_nearby and the holding are
  // computed: that may take 50 times as long as the trial itself.
  std::size_t volumes = std::numeric_limits<std::size_t>::max();
  std::size_t sections = 0;  // as in PlanOptions; at most `volumes`
};

// Where a grasp came from that refine_grasps found.
struct Refinement {
  int parent = 0;     // index into PlanResult::tried of the grasp that was refined
  double gain = 0.0;  // by how much its objective is larger than the parent's
  int trials = 0;     // that were made for it
};

// A grasp with its quality and where it came from.
struct ScoredGrasp {
  Trial trial;          // pose, joints, contacts and epsilon that the trial found
  Candidate candidate;  // what was tried
  // Volume of the convex hull of contact wrenches (6-D, torques scaled); 0 without force closure,
  // nothing where it was not asked for or the call was cancelled before it was computed.
  std::optional<double> volume;
  std::optional<int> primitive;  // index into PlanResult::primitives; none: given by the caller
  std::string rule;              // rule that proposed it, or "given"
  std::optional<Trajectory> path;
  std::optional<WrenchSections> sections;
  int tried = 0;  // index into PlanResult::tried
  // Of a stable grasp: the least and the largest epsilon with the hand moved by next to nothing
  // (epsilon_nearby). Computed with the volume.
  std::optional<Interval> epsilon_nearby = {};
  // Of a grasp with contacts: what its weight takes (payload_margin). Computed with the volume.
  std::optional<PayloadMargin> holding = {};
  // Of a grasp with contacts, where it was asked for: how it fares on disturbed poses.
  std::optional<Robustness> robustness = {};
  std::optional<Refinement> refinement = {};
  std::optional<ShakeReport> shake = {};  // filled in by shake_grasps
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

// All of them, in the order of the enum.
inline constexpr std::array<PlanCount, 9> kPlanCounts = {PlanCount::primitives_given,
                                                         PlanCount::primitives,
                                                         PlanCount::candidates,
                                                         PlanCount::reach,
                                                         PlanCount::obstacles,
                                                         PlanCount::trials,
                                                         PlanCount::refined,
                                                         PlanCount::ranked,
                                                         PlanCount::paths};

// "primitives", "candidates", ...: names of the stages in output for people and in files.
constexpr std::string_view plan_count_name(PlanCount what) {
  constexpr std::array<std::string_view, kPlanCounts.size()> kNames = {
      "primitives given", "primitives", "candidates", "reach", "obstacles",
      "trials",           "refined",    "ranked",     "paths"};
  return kNames[static_cast<std::size_t>(what)];
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

// All of them, in the order of the enum.
inline constexpr std::array<PlanStatus, 5> kPlanStatuses = {
    PlanStatus::complete, PlanStatus::out_of_time, PlanStatus::cancelled,
    PlanStatus::object_too_large, PlanStatus::no_candidates};

// "complete", "cancelled", ...: as in files.
constexpr std::string_view plan_status_name(PlanStatus status) {
  constexpr std::array<std::string_view, kPlanStatuses.size()> kNames = {
      "complete", "out_of_time", "cancelled", "object_too_large", "no_candidates"};
  return kNames[static_cast<std::size_t>(status)];
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
  std::vector<ScoredGrasp> grasps;               // plan: best first; evaluate: in the given order
  std::vector<Tried> tried;                      // finished trials, in the order of candidates
  std::array<int, kOutcomes.size()> outcomes{};  // number of trials with each Outcome
  std::vector<CollisionCount> blockers;          // those with the most candidates first
  // Of plan() without a grasp, unless cancelled: how the candidates of each rule ended, in the
  // order in which the rules were first proposed, and what may help. Empty where there are grasps.
  std::vector<RuleCount> rules;
  std::vector<Advice> advice;
  std::vector<StageCount> stages;  // in the order of the stages
  std::vector<StageTime> times;    // wall-clock time of each stage
  TrialSeconds trial_seconds;      // of all trials, on all threads together
};

// Plans grasps: decomposes the object into primitives (unless the scene gives them), proposes
// candidates, runs a trial of each, ranks the stable ones by epsilon, and with PlanOptions::paths
// plans paths of the arm to the best. The same options give the same result on any number of
// threads (but for times, and unless cancelled).
//
// Does not throw Cancelled. What a cancelled plan returns: the trials that were finished, ranked;
// of grasps whose path was asked for, those whose path was found (cancelled before the first path
// was searched for: the best grasps, without paths); volumes and sections as far as they were
// computed. With one thread the finished trials are the first ones, in the order of the candidates.
// Throws InputError when paths are wanted of a scene without an arm.
//
// `found` is told of the stable trials of the search while it runs, before they are ranked.
PlanResult plan(const CompiledScene& scene, const PlanOptions& options = {},
                const RunContext& context = {}, const FoundListener& found = {});

// Runs a trial of each of the given candidates and scores it. Grasps are returned in the order of
// the candidates, whatever their outcome; nothing is ranked or left out. Does not throw Cancelled:
// when cancelled it returns the grasps whose trials were finished (Tried::candidate says which
// candidates those were). Without candidates the status is PlanStatus::no_candidates.
PlanResult evaluate(const CompiledScene& scene, const std::vector<Candidate>& candidates,
                    const EvaluateOptions& options = {}, const RunContext& context = {});

// Why there was nothing to try, in one line: "mug: no grasp to try with hand NAME: the smallest
// size to close on is ... mm, the hand opens to ... mm; try --hand ...". For a result whose status
// is object_too_large or no_candidates.
std::string no_candidates_text(const CompiledScene& scene, const PlanResult& result);

}  // namespace prehend
