// From a scene to ranked grasps, and from somebody's grasps to their scores.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "planner/path/grasp_path.h"
#include "planner/propose/candidates.h"
#include "planner/search/rank.h"
#include "planner/search/run_trials.h"
#include "planner/search/stopwatch.h"
#include "primitives/decompose.h"
#include "sim/quality/wrench_slice.h"
#include "sim/scene/compiled_scene.h"
#include "sim/trial/trial.h"

namespace prehend {

struct PlanOptions {
  DecomposeOptions primitives;
  CandidateOptions candidates;
  RunTrialsOptions trials;
  RankOptions rank;
  // Paths for the grasps that are returned; those without one are left out. Needs an arm.
  std::optional<GraspPathOptions> paths;
  // So many of the grasps that are returned also get sections of their wrench space.
  std::size_t sections = 0;
};

// A grasp with everything that is said about it.
struct ScoredGrasp {
  Trial trial;
  Candidate candidate;
  double volume = 0.0;  // of the wrench hull, 0 without force closure
  int primitive = -1;   // it came from, -1: given by the caller
  std::string rule;
  std::optional<Trajectory> path;
  std::optional<WrenchSections> sections;
  int tried = 0;  // index into PlanResult::tried
};

// A candidate and how it ended.
struct Tried {
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

struct Stage {
  std::string name;
  int count = 0;  // what came out of it
};

struct PlanResult {
  std::vector<Primitive> primitives;
  std::vector<ScoredGrasp> grasps;               // plan: best first; evaluate: as asked
  std::vector<Tried> tried;                      // all candidates, in the order they were made
  std::array<int, kOutcomes.size()> outcomes{};  // of all trials
  std::vector<Blocker> blockers;                 // those with the most candidates first
  std::vector<Stage> stages;
  std::vector<StageTime> times;
  TrialSeconds trial_seconds;  // of all trials, on all threads together
};

// Throws InputError when no candidate can be proposed: the object is too large for the hand; and
// when paths are wanted of a scene without an arm.
PlanResult plan(const CompiledScene& scene, const PlanOptions& options = {});

// Each candidate is tried where it is; nothing is ranked or left out. `sections`: as in
// PlanOptions.
PlanResult evaluate(const CompiledScene& scene, const std::vector<Candidate>& candidates,
                    const RunTrialsOptions& options = {}, std::size_t sections = 0);

}  // namespace prehend
