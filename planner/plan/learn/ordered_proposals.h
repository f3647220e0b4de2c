// The order of the proposals of a sequence by a model: well-judged ones first, and none that is
// much like one before it.
#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "planner/plan/learn/grasp_features.h"
#include "planner/plan/learn/tree_model.h"
#include "planner/plan/propose/proposal_sequence.h"
#include "sim/base/settings.h"

namespace prehend {

struct LearnedOrder {
  static constexpr AboutSettings kAbout{
      "LearnedOrder",
      "How a model that was learnt from earlier trials orders the "
      "proposals."};
  std::shared_ptr<const TreeModel> model = {};  // not null; fits the scene's hand (require_fit)
  int choose_from = 512;
  // Without variety the first many would be nearly the same grasp, and one error of the model would
  // spoil all of them.
  double variety = 0.5;
  double unordered = 0.1;
  // A model helps a search to begin; later on the neighbours of what was found are better advice.
  int ordered_first = 200;
  // What is easy is found by these, and what becomes of them tells whether the model can judge the
  // hand: where its scores do not rank them, nothing is ordered.
  int unknown_hand_first = 32;
};

template <SettingsOf<LearnedOrder> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [model, choose_from, variety, unordered, ordered_first, unknown_hand_first] = options;
  visit("choose_from", choose_from, kAtLeast1, "",
        "Proposals of solids that wait at any time, and a quarter as many of curves; each next one "
        "is chosen among them.");
  visit("variety", variety, kAtLeast0, "",
        "What is chosen has the largest score, less this times the square of its likeness to the "
        "most alike that came before it.");
  visit("unordered", unordered, kShare, "",
        "Part of the proposals that come in the order of the sequence: what the model scores badly "
        "is tried as well.");
  visit("ordered_first", ordered_first, kAtLeast0, "",
        "Proposals that are ordered; behind them come all that wait, then the sequence goes on in "
        "its own order.");
  visit("unknown_hand_first", unknown_hand_first, kAtLeast0, "",
        "Proposals in the order of the sequence that come first where the model was not trained on "
        "the scene's hand.");
}

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
