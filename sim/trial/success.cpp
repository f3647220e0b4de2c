#include "sim/trial/success.h"

#include <cmath>

namespace prehend {
namespace {

int count_of(const Robustness& robustness, Outcome outcome) { return robustness.outcomes[outcome]; }

}  // namespace

SuccessFacts success_facts(const Robustness& robustness) {
  if (robustness.samples == 0) return {};
  const int closed =
      count_of(robustness, Outcome::stable) + count_of(robustness, Outcome::not_force_closure);
  return {static_cast<double>(closed) / robustness.samples, robustness.probability(),
          robustness.epsilon_mean, robustness.strength};
}

SuccessFeatures success_features(const SuccessFacts& facts) {
  const double strength =
      std::isinf(facts.strength) ? 1.0 : facts.strength / (facts.strength + 10.0);
  return {facts.held * facts.held, facts.epsilon / (facts.epsilon + 0.1), strength};
}

// As printed by fit_success for benchmarks/success/success.csv.
SuccessModel shipped_success_model() {
  return {.intercept = -0.496201, .weights = {1.11845, 2.35319, 1.03214}};
}

double success_probability(const SuccessFacts& facts, const SuccessModel& model) {
  const SuccessFeatures features = success_features(facts);
  double sum = model.intercept;
  for (std::size_t i = 0; i < features.size(); ++i) sum += model.weights[i] * features[i];
  return facts.closed / (1.0 + std::exp(-sum));
}

double success_probability(const Robustness& robustness) {
  return success_probability(success_facts(robustness), shipped_success_model());
}

}  // namespace prehend
