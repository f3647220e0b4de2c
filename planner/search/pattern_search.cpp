#include "planner/search/pattern_search.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace prehend {
namespace {

constexpr double kGrow = 2.0;
constexpr double kShrink = 0.5;
// A step below this part of the first one is as long as the first again: the best point may have
// moved far along the other variables since.
constexpr double kLeastStep = 1.0 / 30.0;

}  // namespace

PatternSearch::PatternSearch(std::size_t variables, double value, double step)
    : best_(variables, 0.0), best_value_(value), first_step_(step), steps_(variables, step) {
  assert(variables > 0 && step > 0.0 && step <= 1.0);
}

std::vector<std::vector<double>> PatternSearch::next(std::size_t count) {
  probes_.clear();
  std::vector<std::vector<double>> points;
  for (std::size_t i = 0; i < std::min(count, best_.size()); ++i) {
    for (const double way : {1.0, -1.0}) {
      const Probe probe = probe_from_best(way);
      probes_.push_back(probe);
      points.push_back(best_);
      points.back()[variable_] = probe.at;
    }
    variable_ = (variable_ + 1) % best_.size();
  }
  return points;
}

PatternSearch::Probe PatternSearch::probe_from_best(double way) const {
  const double from = best_[variable_];
  const double step = steps_[variable_];
  const double at = std::clamp(from + way * step, -1.0, 1.0);
  if (at != from) return {variable_, at, way};
  return {variable_, std::clamp(from - 0.5 * way * step, -1.0, 1.0), -way};
}

void PatternSearch::tell(const std::vector<double>& values) {
  assert(values.size() == probes_.size());
  const double before = best_value_;
  const Probe* taken = nullptr;
  // The probes of a variable stand beside each other: `better` is reset where the next one begins.
  bool better = false;
  for (std::size_t i = 0; i < probes_.size(); ++i) {
    const Probe& probe = probes_[i];
    if (i > 0 && probes_[i - 1].variable != probe.variable) better = false;
    better = better || values[i] > before;
    if (values[i] > best_value_) {
      best_value_ = values[i];
      taken = &probe;
    }
    const bool last = i + 1 == probes_.size() || probes_[i + 1].variable != probe.variable;
    if (last && !better) shorten(probe.variable);
  }
  if (taken != nullptr) {
    best_[taken->variable] = taken->at;
    steps_[taken->variable] *= kGrow * taken->way;
  }
  probes_.clear();
}

void PatternSearch::shorten(std::size_t variable) {
  double& step = steps_[variable];
  step *= kShrink;
  if (std::abs(step) < kLeastStep * first_step_) step = std::copysign(first_step_, step);
}

}  // namespace prehend
