#include "planner/learn/ordered_proposals.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "sim/base/index.h"

namespace prehend {
namespace {

constexpr std::array<Track, 2> kTracks = {Track::solids, Track::curves};

// So many times as many solids as curves wait, as there are more of them to choose from.
constexpr int kSolidsToCurves = 4;

}  // namespace

OrderedProposals::OrderedProposals(const CompiledScene& scene,
                                   const std::vector<Primitive>& primitives,
                                   ProposalSequence& sequence, const LearnedOrder& order)
    : sequence_(&sequence), features_(scene, primitives), order_(order) {
  require_fit(*order.model, scene.scene.hand.name);
  const std::vector<std::string>& known = order.model->hands;
  if (std::find(known.begin(), known.end(), scene.scene.hand.name) == known.end()) {
    in_sequence_first_ = index(order.unknown_hand_first);
  }
}

// Fills what waits.
void OrderedProposals::draw() {
  for (const Track track : kTracks) {
    std::deque<Waiting>& waiting = waiting_[static_cast<std::size_t>(track)];
    const int parts = track == Track::solids ? 1 : kSolidsToCurves;
    const auto wanted = index((order_.choose_from + parts - 1) / parts);
    while (waiting.size() < wanted) {
      std::optional<ProposedGrasp> grasp = sequence_->next(track);
      if (!grasp) break;
      Waiting one{std::move(*grasp), {}, 0.0};
      one.judgement = judge(*order_.model, features_.features(one.grasp));
      for (const Judgement& before : returned_) {
        one.likeness = std::max(one.likeness, likeness(one.judgement, before));
      }
      waiting.push_back(std::move(one));
    }
  }
}

ProposedGrasp OrderedProposals::take(std::deque<Waiting>& from, std::size_t place) {
  const auto taken = from.begin() + static_cast<std::ptrdiff_t>(place);
  ProposedGrasp grasp = std::move(taken->grasp);
  returned_.push_back(std::move(taken->judgement));
  from.erase(taken);
  for (std::deque<Waiting>& waiting : waiting_) {
    for (Waiting& other : waiting) {
      other.likeness = std::max(other.likeness, likeness(other.judgement, returned_.back()));
    }
  }
  return grasp;
}

std::optional<ProposedGrasp> OrderedProposals::best_waiting() {
  std::deque<Waiting>* from = nullptr;
  std::size_t place = 0;
  double most = -std::numeric_limits<double>::infinity();
  for (std::deque<Waiting>& waiting : waiting_) {
    for (std::size_t i = 0; i < waiting.size(); ++i) {
      const double alike = waiting[i].likeness * waiting[i].likeness;
      const double merit = waiting[i].judgement.score - order_.variety * alike;
      if (merit <= most) continue;
      most = merit;
      from = &waiting;
      place = i;
    }
  }
  if (from == nullptr) return std::nullopt;
  return take(*from, place);
}

std::optional<ProposedGrasp> OrderedProposals::next_in_sequence(Track track) {
  std::deque<Waiting>& waiting = waiting_[static_cast<std::size_t>(track)];
  if (waiting.empty()) return sequence_->next(track);
  ProposedGrasp grasp = std::move(waiting.front().grasp);
  waiting.pop_front();
  return grasp;
}

// Behind those at the beginning they are spread evenly over all.
bool OrderedProposals::is_turn_of_sequence() const {
  if (returned_.size() < in_sequence_first_) return true;
  const auto before = static_cast<double>(returned_.size() - in_sequence_first_);
  return std::floor((before + 1.0) * order_.unordered) > std::floor(before * order_.unordered);
}

std::optional<ProposedGrasp> OrderedProposals::next(Track track) {
  if (returned_.size() >= in_sequence_first_ + index(order_.ordered_first)) {
    return next_in_sequence(track);
  }
  draw();
  std::deque<Waiting>& own = waiting_[static_cast<std::size_t>(track)];
  if (is_turn_of_sequence() && !own.empty()) return take(own, 0);
  return best_waiting();
}

}  // namespace prehend
