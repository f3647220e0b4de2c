#include "planner/show/validation/ranking.h"

#include <algorithm>
#include <cassert>
#include <numeric>

namespace prehend {
namespace {

// The weight of each outcome.
struct Weight {
  double lifted = 0.0;
  double failed = 0.0;

  void add(bool has_lifted, double weight) { (has_lifted ? lifted : failed) += weight; }
};

}  // namespace

Ranking::Ranking(std::span<const double> scores, std::span<const Label> labels) {
  assert(scores.size() == labels.size());
  std::vector<std::size_t> order(scores.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return scores[a] > scores[b]; });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool last = i + 1 == order.size();
    const bool ends_tie = last || scores[order[i + 1]] < scores[order[i]];
    places_.push_back({order[i], labels[order[i]].lifted, ends_tie});
  }
}

std::optional<double> Ranking::auc(std::span<const double> weights) const {
  Weight above;
  Weight tie;
  double pairs = 0.0;  // weight of the pairs in the right order
  for (const Place& place : places_) {
    tie.add(place.lifted, weights[place.execution]);
    if (!place.ends_tie) continue;
    pairs += tie.failed * (above.lifted + 0.5 * tie.lifted);
    above.lifted += tie.lifted;
    above.failed += tie.failed;
    tie = {};
  }
  const double all = above.lifted * above.failed;
  if (!(all > 0.0)) return std::nullopt;
  return pairs / all;
}

std::vector<RocPoint> Ranking::roc(std::span<const double> weights) const {
  Weight all;
  for (const Place& place : places_) all.add(place.lifted, weights[place.execution]);
  if (!(all.lifted > 0.0 && all.failed > 0.0)) return {};
  std::vector<RocPoint> points = {{}};
  Weight above;
  for (const Place& place : places_) {
    above.add(place.lifted, weights[place.execution]);
    if (!place.ends_tie) continue;
    points.push_back({above.failed / all.failed, above.lifted / all.lifted});
  }
  return points;
}

std::vector<double> weights_of(std::span<const Label> labels) {
  std::vector<double> weights;
  for (const Label& label : labels) weights.push_back(label.times);
  return weights;
}

}  // namespace prehend
