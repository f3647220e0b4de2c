// Options of plan() and evaluate().
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include "planner/plan/path/grasp_path.h"
#include "planner/plan/propose/candidates.h"
#include "planner/plan/rank.h"
#include "planner/plan/refine_grasps.h"
#include "planner/plan/search_grasps.h"
#include "primitives/decompose.h"
#include "primitives/thin_parts.h"
#include "sim/base/settings.h"
#include "sim/trial/trial_options.h"
#include "sim/trial/uncertainty.h"

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
  // The best grasps of the search are improved by at most a fifth of the trials that it made;
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

}  // namespace prehend
