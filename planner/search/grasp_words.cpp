#include "planner/search/grasp_words.h"

#include <cmath>

#include "sim/base/formatted.h"

namespace prehend {

std::string origin_words(const ScoredGrasp& grasp, const PlanResult& result) {
  if (!grasp.primitive) return grasp.rule;
  const auto p = static_cast<std::size_t>(*grasp.primitive);
  const std::string shape(shape_name(result.primitives[p].shape));
  const std::string refined =
      grasp.refinement ? formatted(", refined +%.3g", grasp.refinement->gain) : "";
  return shape + " " + std::to_string(*grasp.primitive + 1) + " (" + grasp.rule + refined + ")";
}

std::string preshape_name(const CompiledScene& scene, const Candidate& candidate) {
  if (!candidate.preshape) return "";
  return scene.scene.hand.hand->preshapes[static_cast<std::size_t>(*candidate.preshape)].name;
}

std::string strength_words(const Burden& burden) {
  return std::isinf(burden.strength) ? "any" : formatted("%.2g", burden.strength);
}

std::string weakness_words(const Robustness& robustness) {
  if (robustness.weakest_O.isZero(0.0)) return "";
  switch (robustness.weakest_end) {
    case Outcome::hand_blocked:
    case Outcome::approach_blocked:
      return "the hand runs into something";
    case Outcome::no_contact:
      return "the hand closes beside it";
    case Outcome::not_force_closure:
      return "the contacts do not hold it";
    case Outcome::stable:
      return "the drives do not hold its weight";
    default:
      return std::string(outcome_name(robustness.weakest_end));
  }
}

}  // namespace prehend
