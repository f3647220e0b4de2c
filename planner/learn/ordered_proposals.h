// The order of the proposals of a sequence by a model: the best-scored of a pool first.
#pragma once

#include <array>
#include <cstddef>
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
  // The pool holds so many times a batch of proposals (>= 1).
  double choose_from = 8.0;
  // The part of the proposals that the sequence continues in its own order, in 0 .. 1: what the
  // model judges badly is tried as well, later.
  double unordered = 0.2;
};

template <SettingsOf<LearnedOrder> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [model, choose_from, unordered] = options;
  visit("choose_from", choose_from, kAtLeast1);
  visit("unordered", unordered, Range{0.0, 1.0});
}

// The proposals of a sequence, each exactly once as long as it is asked for more. Of each track a
// pool is drawn ahead; what is not chosen stays in it. Of equal scores the earlier proposal is
// chosen. The same arguments give the same order.
class OrderedProposals {
 public:
  // `sequence` and `scene` must outlive it. `batch`: of the search (>= 1). Throws InputError where
  // the model does not fit the scene's hand.
  OrderedProposals(const CompiledScene& scene, const std::vector<Primitive>& primitives,
                   ProposalSequence& sequence, const LearnedOrder& order, int batch);

  // The next grasp of a track, as ProposalSequence::next.
  std::optional<ProposedGrasp> next(Track track);

 private:
  struct Scored {
    ProposedGrasp grasp;
    double score = 0.0;
  };
  struct Pool {
    std::vector<Scored> waiting = {};  // in the order of the sequence
    std::size_t taken = 0;             // proposals so far
  };

  void fill(Track track, Pool& pool);

  ProposalSequence* sequence_;
  FeatureMaker features_;
  LearnedOrder order_;
  std::size_t size_ = 1;  // of a pool
  std::array<Pool, 2> pools_;
};

}  // namespace prehend
