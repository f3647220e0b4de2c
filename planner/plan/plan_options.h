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
#include "planner/plan/search_options.h"
#include "primitives/decompose.h"
#include "primitives/thin_parts.h"
#include "sim/base/settings.h"
#include "sim/trial/trial_options.h"
#include "sim/trial/uncertainty.h"

namespace prehend {

struct PlanOptions {
  static constexpr AboutSettings kAbout{"PlanOptions",
                                        "All that a plan depends on besides its scene."};
  std::uint64_t seed = 1;
  DecomposeOptions primitives;
  ThinPartOptions thin_parts;
  CandidateOptions candidates;
  SearchOptions search;
  TrialOptions trial;
  // Refined grasps that gain less than 1 % of their epsilon are left out.
  RefineOptions refine;
  RankOptions rank;
  int free_closing = 5;
  std::optional<GraspPathOptions> paths;
  bool robustness = false;
  UncertaintyOptions uncertainty;
  bool volumes = true;
  std::size_t sections = 0;
};

// The settings that the grasps depend on. Those of the paths are visited through GraspPathOptions,
// where there are any.
template <SettingsOf<PlanOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [seed, primitives, thin_parts, candidates, search, trial, refine, rank, free_closing, paths,
         robustness, uncertainty, volumes, sections] = options;
  visit("seed", seed, kAtLeast0, "",
        "Everything random in the plan derives from it: seeds in the options below are set from "
        "it, whatever they are.");
  visit({"primitives", ""}, primitives, "How the object's mesh is split.");
  visit({"thin_parts", ""}, thin_parts, "What counts as a rim or a bar.");
  visit({"candidates", ""}, candidates, "How candidates are generated.");
  visit({"search", ""}, search, "How many candidates are tried, and which.");
  visit({"trial", ""}, trial, "How each of them is tried.");
  visit("refine", refine,
        "How the best grasps of the search are improved, by at most two fifths of the trials that "
        "it made.");
  visit({"rank", ""}, rank, "Which grasps are returned.");
  visit("free_closing", free_closing, kCount, "",
        "So many grasps come first that hold an object that is free to move firmly, by the epsilon "
        "where it ends; those that lose it are left out.");
  visit.unlisted(
      "paths", paths,
      "Set: a path of the arm is planned for each grasp, and grasps without one are left "
      "out; needs a scene with an arm.");
  visit("robustness", robustness,
        "Whether the returned grasps are tried again with errors of pose, friction and centre of "
        "mass.");
  visit("uncertainty", uncertainty, "How large these errors are.");
  visit("volumes", volumes,
        "Whether the volume, epsilon_nearby and the holding of the returned grasps are computed, "
        "which takes longer than the trials of all of them.");
  visit.unlisted("sections", sections, kAtLeast0, "",
                 "How many of the returned grasps, the first ones, get sections of their wrench "
                 "space.");
}

struct EvaluateOptions {
  static constexpr AboutSettings kAbout{"EvaluateOptions", "All that an evaluation depends on."};
  std::uint64_t seed = 1;
  TrialOptions trial;
  bool robustness = false;
  UncertaintyOptions uncertainty;
  std::size_t volumes = std::numeric_limits<std::size_t>::max();
  std::size_t sections = 0;
};

template <SettingsOf<EvaluateOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [seed, trial, robustness, uncertainty, volumes, sections] = options;
  visit("seed", seed, kAtLeast0, "", "As in PlanOptions.");
  visit({"trial", ""}, trial, "How each grasp is tried.");
  visit("robustness", robustness, "As in PlanOptions.");
  visit("uncertainty", uncertainty, "As in PlanOptions.");
  visit.unlisted("volumes", volumes, kAtLeast0, "",
                 "For how many of the grasps, the first ones, the volume, epsilon_nearby and the "
                 "holding are computed: that may take 50 times as long as the trial itself.");
  visit.unlisted("sections", sections, kAtLeast0, "", "As in PlanOptions; at most `volumes`.");
}

}  // namespace prehend
