#include "planner/plan/pattern_search.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace prehend {
namespace {

constexpr double kGrow = 2.0;
constexpr double kShrink = 0.5;
// A step below this part of the first one is as long as the first again: the best point may have
// moved far in other directions since.
constexpr double kLeastStep = 1.0 / 30.0;
// How often the search looks along all directions without success before it turns them. The second
// time steps are half as long.
constexpr std::size_t kRoundsBeforeTurn = 2;

}  // namespace

PatternSearch::PatternSearch(std::size_t variables, double value, double step)
    : best_(variables, 0.0),
      best_value_(value),
      first_step_(step),
      directions_(variables, std::vector<double>(variables, 0.0)),
      steps_(variables, step),
      random_(variables) {
  assert(variables > 0 && step > 0.0 && step <= 1.0);
  for (std::size_t i = 0; i < variables; ++i) directions_[i][i] = 1.0;
}

std::vector<std::vector<double>> PatternSearch::next(std::size_t count) {
  probes_.clear();
  std::vector<std::vector<double>> points;
  for (std::size_t i = 0; i < std::min(count, best_.size()); ++i) {
    for (const double way : {1.0, -1.0}) {
      probes_.push_back(probe_from_best(way));
      points.push_back(probes_.back().point);
    }
    direction_ = (direction_ + 1) % best_.size();
  }
  return points;
}

std::vector<double> PatternSearch::point_at(double step) const {
  std::vector<double> point = best_;
  for (std::size_t i = 0; i < point.size(); ++i) {
    point[i] = std::clamp(point[i] + step * directions_[direction_][i], -1.0, 1.0);
  }
  return point;
}

PatternSearch::Probe PatternSearch::probe_from_best(double way) const {
  const double step = steps_[direction_];
  std::vector<double> point = point_at(way * step);
  if (point != best_) return {direction_, way, std::move(point)};
  return {direction_, -way, point_at(-0.5 * way * step)};
}

void PatternSearch::tell(const std::vector<double>& values) {
  assert(values.size() == probes_.size());
  const double before = best_value_;
  Probe* taken = nullptr;
  // The two probes of a direction stand beside each other.
  for (std::size_t i = 0; i + 1 < probes_.size(); i += 2) {
    bool better = false;
    for (const std::size_t k : {i, i + 1}) {
      better = better || values[k] > before;
      if (values[k] > best_value_) {
        best_value_ = values[k];
        taken = &probes_[k];
      }
    }
    failures_ = better ? 0 : failures_ + 1;
    if (!better) shorten(probes_[i].direction);
  }
  if (taken != nullptr) {
    best_ = std::move(taken->point);
    steps_[taken->direction] *= kGrow * taken->way;
  }
  if (failures_ >= kRoundsBeforeTurn * best_.size()) turn_directions();
  probes_.clear();
}

void PatternSearch::shorten(std::size_t direction) {
  double& step = steps_[direction];
  step *= kShrink;
  if (std::abs(step) < kLeastStep * first_step_) step = std::copysign(first_step_, step);
}

// The columns of the reflection about a random plane (Householder) are orthonormal. All steps
// become equally long, the geometric mean of what they were, since they belonged to other
// directions.
void PatternSearch::turn_directions() {
  const std::size_t n = best_.size();
  std::vector<double> normal(n);
  double square = 0.0;
  while (!(square > 0.0)) {
    square = 0.0;
    for (double& x : normal) {
      x = random_.normal();
      square += x * x;
    }
  }
  double logs = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    logs += std::log(std::abs(steps_[i]));
    for (std::size_t j = 0; j < n; ++j) {
      directions_[i][j] = (i == j ? 1.0 : 0.0) - 2.0 * normal[i] * normal[j] / square;
    }
  }
  steps_.assign(n, std::exp(logs / static_cast<double>(n)));
  failures_ = 0;
}

}  // namespace prehend
