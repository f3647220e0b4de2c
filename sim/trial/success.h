// The probability that a grasp lifts its object, from what trials have shown of it.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "sim/trial/perturbed_trials.h"

namespace prehend {

// What the probability follows from. It never falls when one of these grows: less friction and less
// effort of the drives lower `held`, `epsilon` and `strength`, larger errors lower `closed`.
struct SuccessFacts {
  double closed = 0.0;    // share of the disturbed trials in which the hand closed on the object
  double held = 0.0;      // share of them in which it holds the weight
  double epsilon = 0.0;   // mean of their lower bounds of epsilon
  double strength = 0.0;  // times the weight that the drives hold, undisturbed
  std::optional<FreeEnd> free = {};  // what becomes of an object that is free to move
};
SuccessFacts success_facts(const Robustness& robustness);

inline constexpr std::array<std::string_view, 7> kSuccessFeatures = {
    "held", "epsilon", "strength", "kept", "free_epsilon", "free_strength", "stayed"};
using SuccessFeatures = std::array<double, kSuccessFeatures.size()>;

// The facts but `closed` as numbers from 0 to 1, each of which grows with its fact: the square of
// the share held, e / (e + 0.1) of an epsilon e, s / (s + 10) of a strength s, and exp(-d / 30 mm)
// of the distance d by which an object moved that was kept. 0 where it is not known what becomes of
// a free object.
SuccessFeatures success_features(const SuccessFacts& facts);

// A hand that does not close on the object lifts nothing; one that does lifts it with the
// probability of a logistic regression: closed / (1 + exp(-(intercept + weights . features))), no
// weight below 0. The numbers are those of the maximum likelihood for grasps of made-up objects
// that were carried out in simulation (benchmarks/success, docs/reference/success.md).
struct SuccessModel {
  double intercept = 0.0;
  SuccessFeatures weights{};
};
// Where it is known what becomes of a free object, and where it is not.
SuccessModel shipped_success_model(bool free_is_known);

double success_probability(const SuccessFacts& facts, const SuccessModel& model);
double success_probability(const Robustness& robustness);

}  // namespace prehend
