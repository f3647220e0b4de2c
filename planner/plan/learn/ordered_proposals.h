// The order of the proposals of a sequence by a model: well-judged ones first, and none that is
// much like one before it.
#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include "planner/plan/learn/grasp_features.h"
#include "planner/plan/learn/learned_order.h"
#include "planner/plan/learn/tree_model.h"
#include "planner/plan/propose/proposal_sequence.h"

namespace prehend {

struct CompiledScene;

// The proposals of a sequence, each exactly once as long as it is asked for more. Of equal ones the
// earlier proposal is chosen, a solid before a curve. The same arguments give the same order.
class OrderedProposals {
 public:
  // `sequence` and `scene` must outlive it; the sequence is that of the other arguments. Throws
  // InputError where the model does not fit the scene's hand.
  OrderedProposals(const CompiledScene& scene, const std::vector<Primitive>& primitives,
                   const CandidateOptions& candidates, ProposalSequence& sequence,
                   const LearnedOrder& order);

  // The next grasp, which the sequence did not propose before; it is claimed there. As long as they
  // are ordered, it is of the track only where it comes in the order of the sequence: the model
  // chooses among both tracks. Nothing where there are no more.
  std::optional<ProposedGrasp> next(Track track);

  // What became of a proposal: its epsilon, 0 where it does not hold.
  void tell(const ProposedGrasp& grasp, double epsilon);

 private:
  // A proposal that was drawn and not returned.
  struct Waiting {
    ProposedGrasp grasp;
    Prediction prediction;
    double likeness = 0.0;  // to the most alike of those that were returned
  };

  struct Place {
    Track track = Track::solids;
    std::size_t at = 0;
  };
  struct Told {
    double score = 0.0;
    double epsilon = 0.0;
  };

  std::deque<Waiting>& waiting(Track track) { return waiting_[static_cast<std::size_t>(track)]; }
  void draw();
  bool is_turn_of_sequence() const;
  std::optional<Place> best_waiting();
  std::optional<Place> choose(Track track, bool in_sequence);
  std::optional<ProposedGrasp> take(const Place& place);
  std::optional<ProposedGrasp> next_in_sequence(Track track);
  bool ranks_what_was_told() const;

  // Looks ahead on its own, so that neighbours of what was tried are not taken for proposed because
  // they wait.
  ProposalSequence ahead_;
  ProposalSequence* sequence_;
  FeatureMaker features_;
  LearnedOrder order_;
  std::array<std::deque<Waiting>, 2> waiting_;  // of each track, in the order of the sequence
  std::vector<Prediction> returned_;            // until the last ordered one
  int ordered_ = 0;                             // proposals so far whose turn was the model's
  std::size_t to_tell_ = 0;                     // before any is ordered
  std::vector<Told> told_;                      // the first of them
  bool is_trusted_ = true;                      // the model
};

}  // namespace prehend
