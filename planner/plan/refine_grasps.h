// Refinement: the best grasps of a plan, improved by trials of grasps close to them.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "planner/plan/propose/approach_limit.h"
#include "sim/base/named_enum.h"
#include "sim/base/run_context.h"
#include "sim/base/settings.h"
#include "sim/quality/robust_epsilon.h"
#include "sim/trial/candidate.h"
#include "sim/trial/trial.h"
#include "sim/trial/trial_options.h"

namespace prehend {

struct CompiledScene;

// What a refinement makes larger.
enum class RefineObjective {
  epsilon,  // the lower bound of epsilon, by which grasps are ranked
  robust,   // its mean under random errors (RobustEpsilon::mean)
};

// The name in files: the same word as the enumerator.
constexpr auto enum_names(RefineObjective /*of*/) {
  return std::to_array<std::string_view>({"epsilon", "robust"});
}

// The defaults are measured, see docs/reference/refinement.md.
struct RefineOptions {
  static constexpr AboutSettings kAbout{"RefineOptions",
                                        "How the best grasps are improved by trials of grasps near "
                                        "them."};
  RefineObjective objective = RefineObjective::epsilon;
  int grasps = 4;
  int trials = 320;
  // Later changes are longer where that helps and shorter where it does not.
  double turn = 0.2;
  double shift = 0.02;
  NoiseOptions noise = {.samples = 50};
  std::optional<ApproachLimit> approach = {};
};

template <SettingsOf<RefineOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [objective, grasps, trials, turn, shift, noise, approach] = options;
  visit("objective", objective,
        "What is made larger: epsilon, by which grasps are ranked, or its mean under random "
        "errors.");
  visit("grasps", grasps, kCountAbove0, "", "How many of the grasps, the best ones, are refined.");
  visit("trials", trials, kCount, "", "Most trials for all of them together.");
  visit("turn", turn, kAngleAbove0, "rad",
        "First turn of the hand that is tried, about the middle of its contacts.");
  visit("shift", shift, kLengthAbove0, "m", "First shift of the hand that is tried.");
  visit("noise", noise, "The random errors of the objective `robust`.");
  visit.unlisted("approach", approach, "As in CandidateOptions, of which a plan takes it.");
}

// A grasp to refine: what was tried, and its trial.
struct TriedGrasp {
  Candidate candidate;
  Trial trial;
};

// A grasp that is better than the one that it was made from.
struct RefinedGrasp {
  Candidate candidate;
  Trial trial;          // of the candidate; stable, without a back-off
  int parent = 0;       // index into the given grasps
  double gain = 0.0;    // by how much the objective is larger than the parent's, > 0
  int trials_used = 0;  // trials that were made for this parent
};

// How many trials refine_grasps makes for so many given grasps: at most options.trials, whatever
// their results are. Throws InputError as refine_grasps, for the options.
int refine_trials(std::size_t grasps, const RefineOptions& options = {});

// Improves the first options.grasps of `grasps`, each by a pattern search over the pose of its hand
// and the spread of its fingers, in which every step is a trial. After a while the best quarter
// goes on alone, and so on until one is left: all rounds have equally many trials. Returns the
// refined grasps, at most one for each of `grasps` and in their order; none for a grasp than which
// nothing better was found.
//
// A grasp is tried without backing off, so the best is one that holds in the first closing; with
// the same options, run_trial gives the same trial of its candidate.
//
// The trials of a step run in parallel on context.threads threads; the result is the same on any
// number of them. No step begins after context.deadline. Reports progress after each trial.
//
// Throws InputError for options outside their range, for a grasp whose trial is not stable or has
// no contacts ("grasps[2].trial: not stable"), and Cancelled.
std::vector<RefinedGrasp> refine_grasps(const CompiledScene& scene,
                                        const std::vector<TriedGrasp>& grasps,
                                        const TrialOptions& options = {},
                                        const RefineOptions& refine = {},
                                        const RunContext& context = {});

}  // namespace prehend
