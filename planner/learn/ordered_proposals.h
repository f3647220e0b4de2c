// The order of the proposals of a sequence by a model: well-judged ones first, and none that is
// much like one before it.
#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "planner/learn/grasp_features.h"
#include "planner/learn/tree_model.h"
#include "planner/propose/proposal_sequence.h"
#include "sim/base/settings.h"

namespace prehend {

// How a model orders the candidates of a search.
struct LearnedOrder {
  std::shared_ptr<const TreeModel> model = {};  // not null; fits the scene's hand (require_fit)
  // So many proposals of solids wait at any time, and a quarter as many of curves; each next one is
  // chosen among them (>= 1).
  int choose_from = 512;
  // What is chosen has the largest score, less `variety` (>= 0) times the square of its
  // likeness (tree_model.h) to the most alike that came before it. Without, the first many would be
  // nearly the same grasp, and one error of the model would spoil all of them.
  double variety = 0.5;
  // The part of the proposals, in 0 .. 1, that come in the order of the sequence: what the model
  // judges badly is tried as well.
  double unordered = 0.1;
  // So many proposals are ordered (>= 0). Behind them come all that wait, and then the sequence
  // goes on, in its own order: a model helps a search to begin, and later on the neighbours of what
  // was found are better advice.
  int ordered_first = 200;
  // Before them come so many in the order of the sequence (>= 0) where the model was not trained on
  // the scene's hand: what is easy is found by these, so that a model that misjudges the hand costs
  // little.
  int unknown_hand_first = 32;
};

template <SettingsOf<LearnedOrder> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [model, choose_from, variety, unordered, ordered_first, unknown_hand_first] = options;
  visit("choose_from", choose_from, kAtLeast1);
  visit("variety", variety, kAtLeast0);
  visit("unordered", unordered, Range{0.0, 1.0});
  visit("ordered_first", ordered_first, kAtLeast0);
  visit("unknown_hand_first", unknown_hand_first, kAtLeast0);
}

// The proposals of a sequence, each exactly once as long as it is asked for more. Of equal ones the
// earlier proposal is chosen, a solid before a curve. The same arguments give the same order.
class OrderedProposals {
 public:
  // `sequence` and `scene` must outlive it. Throws InputError where the model does not fit the
  // scene's hand.
  OrderedProposals(const CompiledScene& scene, const std::vector<Primitive>& primitives,
                   ProposalSequence& sequence, const LearnedOrder& order);

  // The next grasp. As long as they are ordered, it is of the track only where it comes in the
  // order of the sequence; the model chooses among both tracks. Nothing where the track has no
  // more, and nothing of the other one is to be chosen.
  std::optional<ProposedGrasp> next(Track track);

 private:
  // A proposal that was drawn and not returned.
  struct Waiting {
    ProposedGrasp grasp;
    Judgement judgement;
    double likeness = 0.0;  // to the most alike of those that were returned
  };

  void draw();
  std::optional<ProposedGrasp> next_in_sequence(Track track);
  std::optional<ProposedGrasp> best_waiting();
  ProposedGrasp take(std::deque<Waiting>& from, std::size_t place);
  bool is_turn_of_sequence() const;

  ProposalSequence* sequence_;
  FeatureMaker features_;
  LearnedOrder order_;
  std::size_t in_sequence_first_ = 0;           // proposals before the ordered ones
  std::array<std::deque<Waiting>, 2> waiting_;  // of each track, in the order of the sequence
  std::vector<Judgement> returned_;             // while they are ordered
};

}  // namespace prehend
