// The search for grasps: which candidates are tried, in which order.
#pragma once

#include <vector>

#include "planner/plan/propose/candidates.h"
#include "planner/plan/search_options.h"
#include "sim/base/run_context.h"
#include "sim/shape/primitive.h"
#include "sim/trial/trial.h"

namespace prehend {

struct CompiledScene;
struct TrialOptions;

// Why a search ended.
enum class SearchEnd {
  trials,       // as many as asked for were made
  settled,      // the last of them made the best grasps no better
  enough,       // as many grasps as asked for hold
  no_proposal,  // nothing was left to propose: nothing fits the hand, or all was tried
  blocked,      // too many hands were blocked on their way
  out_of_time,
  cancelled
};

// What is kept of the trials.
enum class KeptTrials {
  whole,
  // Where any holds, the others without their contacts and postures, which take more memory than
  // all else of them: what a ranking needs, and advice where nothing holds.
  holding
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

// Tries candidates until there are enough trials, the context is cancelled, or its deadline has
// passed. The same arguments give the same proposals and trials on any number of threads. Cut short
// by time or cancellation, they are a beginning of them, without those of the last batch that were
// not finished. Throws InputError where a learned order does not fit the scene's hand.
SearchResult search_grasps(const CompiledScene& scene, const std::vector<Primitive>& primitives,
                           const CandidateOptions& candidates, const SearchOptions& search,
                           const TrialOptions& trial, const RunContext& context = {},
                           const FoundListener& found = {}, KeptTrials kept = KeptTrials::whole);

}  // namespace prehend
