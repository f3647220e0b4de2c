#include "planner/show/validation/scores.h"

#include <array>

#include "sim/trial/success.h"

namespace prehend {
namespace {

bool holds_by_contacts(const ScoredGrasp& grasp) { return grasp.trial.outcome == Outcome::stable; }

double epsilon_of(const ScoredGrasp& grasp) {
  return holds_by_contacts(grasp) ? grasp.trial.epsilon.lower : 0.0;
}

// A number of the trials with errors, 0 where there were none.
template <typename Member>
double of_robustness(const ScoredGrasp& grasp, Member Robustness::*member) {
  return grasp.robustness ? (*grasp.robustness).*member : 0.0;
}

using Grasp = const ScoredGrasp&;

constexpr std::array<Score, 10> kScores = {{
    {"force_closure", "force closure", false, false,
     [](Grasp grasp) { return holds_by_contacts(grasp) ? 1.0 : 0.0; }},
    {"epsilon", "epsilon", false, false, epsilon_of},
    {"volume", "volume", false, true, [](Grasp grasp) { return grasp.volume.value_or(0.0); }},
    {"weight_given", "times the weight, as it lies", false, false,
     [](Grasp grasp) { return grasp.holding ? grasp.holding->given.strength : 0.0; }},
    {"weight_worst", "times the weight, at worst", false, false,
     [](Grasp grasp) { return grasp.holding ? grasp.holding->worst.strength : 0.0; }},
    {"probability", "probability", true, false,
     [](Grasp grasp) { return grasp.robustness ? grasp.robustness->probability() : 0.0; }},
    {"success", "success", true, false,
     [](Grasp grasp) { return grasp.robustness ? success_probability(*grasp.robustness) : 0.0; }},
    {"epsilon_mean", "mean epsilon with errors", false, false,
     [](Grasp grasp) { return of_robustness(grasp, &Robustness::epsilon_mean); }},
    {"epsilon_low", "low epsilon with errors", false, false,
     [](Grasp grasp) { return of_robustness(grasp, &Robustness::epsilon_low); }},
    {"spare", "spare", false, false,
     [](Grasp grasp) { return of_robustness(grasp, &Robustness::position_margin); }},
}};

}  // namespace

std::vector<Score> scores(bool with_volume) {
  std::vector<Score> chosen;
  for (const Score& score : kScores) {
    if (with_volume || !score.needs_volume) chosen.push_back(score);
  }
  return chosen;
}

}  // namespace prehend
