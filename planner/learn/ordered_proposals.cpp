#include "planner/learn/ordered_proposals.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace prehend {

OrderedProposals::OrderedProposals(const CompiledScene& scene,
                                   const std::vector<Primitive>& primitives,
                                   ProposalSequence& sequence, const LearnedOrder& order, int batch)
    : sequence_(&sequence), features_(scene, primitives), order_(order) {
  require_fit(*order.model, scene.scene.hand.name);
  size_ = static_cast<std::size_t>(std::max(1.0, order.choose_from * static_cast<double>(batch)));
}

void OrderedProposals::fill(Track track, Pool& pool) {
  while (pool.waiting.size() < size_) {
    std::optional<ProposedGrasp> grasp = sequence_->next(track);
    if (!grasp) break;
    const GraspFeatures features = features_.features(*grasp);
    pool.waiting.push_back({std::move(*grasp), score(*order_.model, features)});
  }
}

std::optional<ProposedGrasp> OrderedProposals::next(Track track) {
  Pool& pool = pools_[static_cast<std::size_t>(track)];
  fill(track, pool);
  if (pool.waiting.empty()) return std::nullopt;
  // The unordered part is spread evenly over all.
  const auto before = static_cast<double>(pool.taken);
  const bool in_turn =
      std::floor((before + 1.0) * order_.unordered) > std::floor(before * order_.unordered);
  ++pool.taken;
  auto chosen = pool.waiting.begin();
  if (!in_turn) {
    chosen = std::max_element(pool.waiting.begin(), pool.waiting.end(),
                              [](const Scored& a, const Scored& b) { return a.score < b.score; });
  }
  ProposedGrasp grasp = std::move(chosen->grasp);
  pool.waiting.erase(chosen);
  return grasp;
}

}  // namespace prehend
