#include "planner/plan/learn/ordered_proposals.h"

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

// A model whose scores have a smaller rank correlation with the outcomes is not trusted.
constexpr double kLeastCorrelation = 0.2;

// The rank of each value, the mean of their ranks where some are equal, less the mean of all.
std::vector<double> centered_ranks(const std::vector<double>& values) {
  std::vector<double> ranks;
  for (const double value : values) {
    double rank = 0.0;
    for (const double other : values) rank += other < value ? 0.5 : other > value ? -0.5 : 0.0;
    ranks.push_back(rank);
  }
  return ranks;
}

// Spearman's; 0 where all of one are equal.
double rank_correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const std::vector<double> x = centered_ranks(a);
  const std::vector<double> y = centered_ranks(b);
  double xy = 0.0;
  double xx = 0.0;
  double yy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xy += x[i] * y[i];
    xx += x[i] * x[i];
    yy += y[i] * y[i];
  }
  return xx * yy > 0.0 ? xy / std::sqrt(xx * yy) : 0.0;
}

}  // namespace

OrderedProposals::OrderedProposals(const CompiledScene& scene,
                                   const std::vector<Primitive>& primitives,
                                   const CandidateOptions& candidates, ProposalSequence& sequence,
                                   const LearnedOrder& order)
    : ahead_(scene, primitives, candidates),
      sequence_(&sequence),
      features_(scene, primitives),
      order_(order) {
  require_fit(*order.model, scene.scene.hand.name);
  const std::vector<std::string>& known = order.model->hands;
  if (std::find(known.begin(), known.end(), scene.scene.hand.name) == known.end()) {
    to_tell_ = index(order.unknown_hand_first);
  }
}

// Fills what waits.
void OrderedProposals::draw() {
  for (const Track track : kTracks) {
    const int parts = track == Track::solids ? 1 : kSolidsToCurves;
    const auto wanted = index((order_.choose_from + parts - 1) / parts);
    while (waiting(track).size() < wanted) {
      std::optional<ProposedGrasp> grasp = ahead_.next(track);
      if (!grasp) break;
      Waiting one{std::move(*grasp), {}, 0.0};
      one.prediction = predict(*order_.model, features_.features(one.grasp));
      for (const Prediction& before : returned_) {
        one.likeness = std::max(one.likeness, likeness(one.prediction, before));
      }
      waiting(track).push_back(std::move(one));
    }
  }
}

// Nothing where the sequence had proposed it meanwhile.
std::optional<ProposedGrasp> OrderedProposals::take(const Place& place) {
  std::deque<Waiting>& from = waiting(place.track);
  const auto taken = from.begin() + static_cast<std::ptrdiff_t>(place.at);
  const Waiting one = std::move(*taken);
  from.erase(taken);
  if (!sequence_->mark_proposed(one.grasp)) return std::nullopt;
  returned_.push_back(one.prediction);
  for (const Track track : kTracks) {
    for (Waiting& other : waiting(track)) {
      other.likeness = std::max(other.likeness, likeness(other.prediction, one.prediction));
    }
  }
  return one.grasp;
}

std::optional<OrderedProposals::Place> OrderedProposals::best_waiting() {
  std::optional<Place> best;
  double most = -std::numeric_limits<double>::infinity();
  for (const Track track : kTracks) {
    for (std::size_t i = 0; i < waiting(track).size(); ++i) {
      const Waiting& one = waiting(track)[i];
      const double merit = one.prediction.score - order_.variety * one.likeness * one.likeness;
      if (merit <= most) continue;
      most = merit;
      best = Place{track, i};
    }
  }
  return best;
}

std::optional<OrderedProposals::Place> OrderedProposals::choose(Track track, bool in_sequence) {
  if (in_sequence && !waiting(track).empty()) return Place{track, 0};
  return best_waiting();
}

std::optional<ProposedGrasp> OrderedProposals::next_in_sequence(Track track) {
  while (true) {
    std::optional<ProposedGrasp> grasp;
    if (waiting(track).empty()) {
      grasp = ahead_.next(track);
    } else {
      grasp = std::move(waiting(track).front().grasp);
      waiting(track).pop_front();
    }
    if (!grasp || sequence_->mark_proposed(*grasp)) return grasp;
  }
}

// They are spread evenly over all.
bool OrderedProposals::is_turn_of_sequence() const {
  const double before = ordered_;
  return std::floor((before + 1.0) * order_.unordered) > std::floor(before * order_.unordered);
}

std::optional<ProposedGrasp> OrderedProposals::next(Track track) {
  if (ordered_ >= order_.ordered_first || !is_trusted_) return next_in_sequence(track);
  const bool is_told = told_.size() >= to_tell_;
  const bool in_sequence = !is_told || is_turn_of_sequence();
  if (is_told) ++ordered_;
  while (true) {
    draw();
    const std::optional<Place> place = choose(track, in_sequence);
    if (!place) return std::nullopt;
    if (std::optional<ProposedGrasp> grasp = take(*place)) return grasp;
  }
}

bool OrderedProposals::ranks_what_was_told() const {
  std::vector<double> scores;
  std::vector<double> epsilons;
  for (const Told& one : told_) {
    scores.push_back(one.score);
    epsilons.push_back(one.epsilon);
  }
  return rank_correlation(scores, epsilons) >= kLeastCorrelation;
}

void OrderedProposals::tell(const ProposedGrasp& grasp, double epsilon) {
  if (told_.size() >= to_tell_) return;
  told_.push_back({score(*order_.model, features_.features(grasp)), epsilon});
  if (told_.size() == to_tell_) is_trusted_ = ranks_what_was_told();
}

}  // namespace prehend
