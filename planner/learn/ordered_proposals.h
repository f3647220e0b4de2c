// The order of the proposals of a sequence by a model: of every few, the best-scored come first.
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
  // Of so many successive proposals (>= 1), the best `chosen` (1 .. choose_from) are tried, the
  // others wait. Only neighbours in the sequence compete: it spreads any beginning of itself over
  // all ways to grasp, and the best of all proposals would be many times nearly the same grasp.
  int choose_from = 4;
  int chosen = 1;
  // The part of the proposals, in 0 .. 1, that are those that wait, in the order of the sequence:
  // what the model judges badly is tried as well, later.
  double unordered = 0.2;
  // So many proposals of solids, and of curves, are ordered (>= 0). Behind them come all that wait,
  // and then the sequence goes on, in its own order: a model helps a search to begin, and later on
  // the neighbours of what was found are better advice.
  int ordered_first = 100;
};

template <SettingsOf<LearnedOrder> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [model, choose_from, chosen, unordered, ordered_first] = options;
  visit("choose_from", choose_from, kAtLeast1);
  visit("chosen", chosen, kAtLeast1);
  visit("unordered", unordered, Range{0.0, 1.0});
  visit("ordered_first", ordered_first, kAtLeast0);
}

// The proposals of a sequence, each exactly once as long as it is asked for more. Of equal scores
// the earlier proposal is chosen. The same arguments give the same order.
class OrderedProposals {
 public:
  // `sequence` and `scene` must outlive it. Throws InputError where the model does not fit the
  // scene's hand.
  OrderedProposals(const CompiledScene& scene, const std::vector<Primitive>& primitives,
                   ProposalSequence& sequence, const LearnedOrder& order);

  // The next grasp of a track, as ProposalSequence::next.
  std::optional<ProposedGrasp> next(Track track);

 private:
  // The proposals of a track that were drawn and not returned.
  struct Drawn {
    std::deque<ProposedGrasp> chosen = {};   // the best first
    std::deque<ProposedGrasp> waiting = {};  // in the order of the sequence
    std::size_t returned = 0;                // proposals so far
  };

  void draw(Track track, Drawn& drawn);
  bool is_turn_of_waiting(const Drawn& drawn) const;

  ProposalSequence* sequence_;
  FeatureMaker features_;
  LearnedOrder order_;
  std::array<Drawn, 2> drawn_;
};

}  // namespace prehend
