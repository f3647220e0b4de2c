#include "planner/learn/ordered_proposals.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "sim/base/index.h"

namespace prehend {

OrderedProposals::OrderedProposals(const CompiledScene& scene,
                                   const std::vector<Primitive>& primitives,
                                   ProposalSequence& sequence, const LearnedOrder& order)
    : sequence_(&sequence), features_(scene, primitives), order_(order) {
  require_fit(*order.model, scene.scene.hand.name);
}

void OrderedProposals::draw(Track track, Drawn& drawn) {
  std::vector<ProposedGrasp> grasps;
  std::vector<double> scores;
  while (static_cast<int>(grasps.size()) < order_.choose_from) {
    std::optional<ProposedGrasp> grasp = sequence_->next(track);
    if (!grasp) break;
    scores.push_back(score(*order_.model, features_.features(*grasp)));
    grasps.push_back(std::move(*grasp));
  }
  std::vector<std::size_t> by_score(grasps.size());
  std::iota(by_score.begin(), by_score.end(), std::size_t{0});
  std::stable_sort(by_score.begin(), by_score.end(),
                   [&](std::size_t a, std::size_t b) { return scores[a] > scores[b]; });
  const std::size_t chosen = std::min(by_score.size(), index(std::max(order_.chosen, 1)));
  std::sort(by_score.begin() + static_cast<std::ptrdiff_t>(chosen), by_score.end());
  for (std::size_t i = 0; i < by_score.size(); ++i) {
    (i < chosen ? drawn.chosen : drawn.waiting).push_back(std::move(grasps[by_score[i]]));
  }
}

// They are spread evenly over all.
bool OrderedProposals::is_turn_of_waiting(const Drawn& drawn) const {
  const auto before = static_cast<double>(drawn.returned);
  return std::floor((before + 1.0) * order_.unordered) > std::floor(before * order_.unordered);
}

std::optional<ProposedGrasp> OrderedProposals::next(Track track) {
  Drawn& drawn = drawn_[static_cast<std::size_t>(track)];
  const bool ordered = static_cast<double>(drawn.returned) < order_.ordered_first;
  if (!ordered && drawn.chosen.empty() && drawn.waiting.empty()) return sequence_->next(track);
  const bool waiting_first = is_turn_of_waiting(drawn);
  if (ordered && drawn.chosen.empty() && !(waiting_first && !drawn.waiting.empty()))
    draw(track, drawn);
  const bool from_waiting = !drawn.waiting.empty() && (waiting_first || drawn.chosen.empty());
  std::deque<ProposedGrasp>& from = from_waiting ? drawn.waiting : drawn.chosen;
  if (from.empty()) return std::nullopt;
  ++drawn.returned;
  ProposedGrasp grasp = std::move(from.front());
  from.pop_front();
  return grasp;
}

}  // namespace prehend
