// From a scene to ranked grasps, and from somebody's grasps to their scores.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "planner/path/grasp_path.h"
#include "planner/propose/candidates.h"
#include "planner/search/rank.h"
#include "planner/search/run_trials.h"
#include "planner/search/stopwatch.h"
#include "primitives/decompose.h"
#include "sim/base/run_context.h"
#include "sim/base/settings.h"
#include "sim/quality/wrench_slice.h"
#include "sim/scene/compiled_scene.h"
#include "sim/trial/trial.h"

namespace prehend {

struct PlanOptions {
  // Everything random in the plan derives from it (run_seed.h): seeds in the options below are set
  // from it, whatever they are.
  std::uint64_t seed = 1;
  DecomposeOptions primitives;
  CandidateOptions candidates;
  TrialOptions trial;
  RankOptions rank;
  // Paths for the grasps that are returned; those without one are left out. Needs an arm.
  std::optional<GraspPathOptions> paths;
  // So many of the grasps that are returned also get sections of their wrench space.
  std::size_t sections = 0;
};

// All that grasps depend on but the paths, which are optional: GraspPathOptions has settings too.
template <SettingsOf<PlanOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [seed, primitives, candidates, trial, rank, paths, sections] = options;
  visit("seed", seed);
  visit("", primitives);
  visit("", candidates);
  visit("", trial);
  visit("", rank);
}

struct EvaluateOptions {
  std::uint64_t seed = 1;  // as in PlanOptions
  TrialOptions trial;
  std::size_t sections = 0;  // as in PlanOptions
};

// A grasp with everything that is said about it.
struct ScoredGrasp {
  Trial trial;
  Candidate candidate;
  // Of the wrench hull, 0 without force closure; nothing where the call was cancelled before it.
  std::optional<double> volume;
  std::optional<int> primitive;  // it came from; none: given by the caller
  std::string rule;
  std::optional<Trajectory> path;
  std::optional<WrenchSections> sections;
  int tried = 0;  // index into PlanResult::tried
};

// A candidate and how it ended.
struct Tried {
  int candidate = 0;                      // its place among those that were proposed or given
  Pose X_OH = Pose::Identity();           // where its approach was to end
  Vector3 approach_O = Vector3::UnitZ();  // unit
  Outcome outcome = Outcome::no_contact;
  Blame blame;
};

// How many candidates ended in `outcome` because one link met one body.
struct Blocker {
  Outcome outcome = Outcome::hand_blocked;
  std::string link;
  std::string by;  // the object, an obstacle, or another link
  int count = 0;
};

// What is counted on the way from primitives to grasps.
enum class PlanCount {
  primitives_given,  // by the scene
  primitives,        // found in the object's mesh
  candidates,        // proposed
  reach,             // of those tried, candidates that the arm brings the hand to
  obstacles,
  trials,  // candidates that were tried
  ranked,  // grasps that hold, without near-identical ones
  paths    // of them, those with a path
};

constexpr std::string_view plan_count_name(PlanCount what) {
  constexpr std::array<std::string_view, 8> kNames = {
      "primitives given", "primitives", "candidates", "reach",
      "obstacles",        "trials",     "ranked",     "paths"};
  return kNames[static_cast<std::size_t>(what)];
}

struct StageCount {
  PlanCount what = PlanCount::primitives;
  int count = 0;
};

// How a call ended whose question was sound.
enum class PlanStatus {
  complete,
  cancelled,         // the context was cancelled before all was done; what was found is there
  object_too_large,  // no rule of any primitive fits into the hand: see the sizes in PlanResult
  no_candidates      // there was nothing to try for another reason
};

constexpr std::string_view plan_status_name(PlanStatus status) {
  constexpr std::array<std::string_view, 4> kNames = {"complete", "cancelled", "object_too_large",
                                                      "no_candidates"};
  return kNames[static_cast<std::size_t>(status)];
}

struct PlanResult {
  PlanStatus status = PlanStatus::complete;
  // Candidates that were proposed or given, but not tried to the end: 0 unless cancelled.
  int untested = 0;
  // Of the proposals: the smallest size that a rule wanted to close on (infinite where there was no
  // rule at all), and the largest size that an opening of the hand takes [m].
  double smallest_width = 0.0;
  double largest_opening = 0.0;
  std::vector<Primitive> primitives;
  std::vector<ScoredGrasp> grasps;               // plan: best first; evaluate: as asked
  std::vector<Tried> tried;                      // all that were tried, in the order they were made
  std::array<int, kOutcomes.size()> outcomes{};  // of all trials
  std::vector<Blocker> blockers;                 // those with the most candidates first
  std::vector<StageCount> stages;
  std::vector<StageTime> times;
  TrialSeconds trial_seconds;  // of all trials, on all threads together
};

// Decomposes the object (unless the scene gives primitives), proposes candidates, tries them, ranks
// those that hold, and with PlanOptions::paths plans the arm's way to the best.
//
// Does not throw Cancelled. What a cancelled plan returns: the trials that were finished, ranked;
// of grasps whose path was asked for, those whose path was found (cancelled before the first path
// was searched for: the best grasps, without paths); volumes and sections as far as they were
// computed. With one thread the finished trials are the first ones, in the order of the candidates.
// Throws InputError when paths are wanted of a scene without an arm.
PlanResult plan(const CompiledScene& scene, const PlanOptions& options = {},
                const RunContext& context = {});

// Each candidate is tried where it is; nothing is ranked or left out. Does not throw Cancelled: it
// returns the grasps whose trials were finished, in their order (Tried::candidate says which those
// are). No candidates at all: PlanStatus::no_candidates.
PlanResult evaluate(const CompiledScene& scene, const std::vector<Candidate>& candidates,
                    const EvaluateOptions& options = {}, const RunContext& context = {});

// One line for people: "mug: no grasp to try with hand NAME: the smallest size to close on is ...
// mm, the hand opens to ... mm". For a result whose status is object_too_large or no_candidates.
std::string no_candidates_words(const CompiledScene& scene, const PlanResult& result);

}  // namespace prehend
