// The search for grasps: which candidates are tried, in which order.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "planner/plan/learn/ordered_proposals.h"
#include "planner/plan/propose/candidates.h"
#include "sim/base/run_context.h"
#include "sim/base/settings.h"
#include "sim/trial/trial.h"
#include "sim/trial/trial_options.h"

namespace prehend {

// How many candidates are tried, and how much the search follows what it finds.
struct SearchOptions {
  // Most trials (>= 1). Those whose hand is blocked on its way to the object (is_blocked) cost next
  // to nothing and are not counted, up to most_blocked times as many (>= 0). With an arm,
  // candidates come first whose hand has an orientation near which the arm reached others.
  int trials = 800;
  int most_blocked = 10;
  // The search ends after the batch in which it has found so many stable grasps; 0: after all
  // trials (>= 0).
  int enough = 0;
  // Candidates are chosen in batches of this size; what is chosen depends on all trials of the
  // batches before, in whatever order threads finish them (>= 1).
  int batch = 32;
  // The part of a batch that lies beside the best grasps so far, in 0 .. 1; the others continue the
  // sequence of proposals.
  double local_fraction = 0.3;
  // How many of the best grasps are followed.
  int followed = 10;
  // While no grasp has an epsilon of at least thin_parts_if_epsilon_below (>= 0), rims and bars are
  // tried in turn with boxes, spheres, cylinders and cones: from the part thin_parts_after_fraction
  // of the trials on, at least for the part thin_parts_min_fraction of them, and longer where some
  // of them are among the grasps that are followed (both in 0 .. 1).
  double thin_parts_if_epsilon_below = 0.15;
  double thin_parts_after_fraction = 0.2;
  double thin_parts_min_fraction = 0.06;
  // Where after so many trials (>= 0) none has held, the hand backs off more often in those that
  // follow: extra_back_offs times (>= 0), if a trial does not anyway. Fingers that swing while
  // they close, as those of the Robotiq 2F-85, may hold a box only at their tips.
  int trials_before_extra_back_offs = 100;
  int extra_back_offs = 4;
  // Set: a model that was learnt from earlier trials orders the proposals of the sequence
  // (docs/how-to/learning.md).
  std::optional<LearnedOrder> learned = {};
};

// The settings of a learned order, where there is one, are visited through LearnedOrder.
template <SettingsOf<SearchOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [trials, most_blocked, enough, batch, local_fraction, followed, thin_parts_if_epsilon_below,
         thin_parts_after_fraction, thin_parts_min_fraction, trials_before_extra_back_offs,
         extra_back_offs, learned] = options;
  visit("trials", trials, kAtLeast1);
  visit("most_blocked", most_blocked, kAtLeast0);
  visit("enough", enough, kAtLeast0);
  visit("batch", batch, kAtLeast1);
  visit("follow", local_fraction, Range{0.0, 1.0});
  visit("followed", followed, kAtLeast0);
  visit("well_served", thin_parts_if_epsilon_below, kAtLeast0);
  visit("solids_first", thin_parts_after_fraction, Range{0.0, 1.0});
  visit("curves_least", thin_parts_min_fraction, Range{0.0, 1.0});
  visit("patience", trials_before_extra_back_offs, kAtLeast0);
  visit("patient_back_offs", extra_back_offs, kAtLeast0);
}

// Why a search ended.
enum class SearchEnd {
  trials,       // as many as asked for were made
  enough,       // as many grasps as asked for hold
  no_proposal,  // nothing was left to propose: nothing fits the hand, or all was tried
  blocked,      // too many hands were blocked on their way
  out_of_time,
  cancelled
};

struct SearchResult {
  std::vector<ProposedGrasp> proposed;  // in the order of the search
  std::vector<Trial> trials;            // those that were finished
  std::vector<std::size_t> candidates;  // of each trial, the index into `proposed`
  SearchEnd end = SearchEnd::trials;
  int families = 0;             // see ProposalSequence
  int families_untested = 0;    // without any trial
  double smallest_width = 0.0;  // as in Proposals
  double largest_opening = 0.0;
};

// Is told of each stable trial of a search as soon as its batch is finished, in the order of the
// candidates; may be empty. Never called by two threads at once.
using FoundListener = std::function<void(const Candidate&, const Trial&)>;

// Tries candidates until there are enough trials, the context is cancelled, or its deadline has
// passed. The same arguments give the same proposals and trials on any number of threads. Cut short
// by time or cancellation, they are a beginning of them, without those of the last batch that were
// not finished. Throws InputError where a learned order does not fit the scene's hand.
SearchResult search_grasps(const CompiledScene& scene, const std::vector<Primitive>& primitives,
                           const CandidateOptions& candidates, const SearchOptions& search,
                           const TrialOptions& trial, const RunContext& context = {},
                           const FoundListener& found = {});

}  // namespace prehend
