#include "sim/trial/success.h"

#include <cmath>

namespace prehend {
namespace {

double of_epsilon(double epsilon) { return epsilon / (epsilon + 0.1); }

double of_strength(double strength) {
  return std::isinf(strength) ? 1.0 : strength / (strength + 10.0);
}

}  // namespace

SuccessFacts success_facts(const Robustness& robustness) {
  if (robustness.samples == 0) return {};
  return {static_cast<double>(robustness.closed()) / robustness.samples, robustness.probability(),
          robustness.epsilon_mean, robustness.strength, robustness.free};
}

SuccessFeatures success_features(const SuccessFacts& facts) {
  SuccessFeatures features = {facts.held * facts.held, of_epsilon(facts.epsilon),
                              of_strength(facts.strength)};
  if (!facts.free || !facts.free->kept) return features;
  features[3] = 1.0;
  features[4] = of_epsilon(facts.free->epsilon);
  features[5] = of_strength(facts.free->strength);
  features[6] = std::exp(-facts.free->moved / 0.03);
  return features;
}

// As printed by fit_success for benchmarks/success/success.csv.
SuccessModel shipped_success_model(bool free_is_known) {
  if (free_is_known) {
    return {.intercept = -1.8403,
            .weights = {0.868722, 0, 0, 1.02672, 2.84339, 0.274476, 0.981121}};
  }
  return {.intercept = -0.316485, .weights = {1.23469, 0.192986, 0.974153}};
}

double success_probability(const SuccessFacts& facts, const SuccessModel& model) {
  const SuccessFeatures features = success_features(facts);
  double sum = model.intercept;
  for (std::size_t i = 0; i < features.size(); ++i) sum += model.weights[i] * features[i];
  return facts.closed / (1.0 + std::exp(-sum));
}

double success_probability(const Robustness& robustness) {
  return success_probability(success_facts(robustness),
                             shipped_success_model(robustness.free.has_value()));
}

}  // namespace prehend
