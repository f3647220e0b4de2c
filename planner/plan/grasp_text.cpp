#include "planner/plan/grasp_text.h"

#include <numbers>

#include "planner/plan/plan_result.h"
#include "sim/base/formatted.h"
#include "sim/scene/compiled_scene.h"

namespace prehend {

std::string origin_text(const ScoredGrasp& grasp, const PlanResult& result) {
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

std::string opening_text(const CompiledScene& scene, const Candidate& candidate) {
  const std::string preshape = preshape_name(scene, candidate);
  const std::string closing = strategy_of(scene.scene.hand, candidate).name;
  return (preshape.empty() ? "-" : preshape) + (closing.empty() ? "" : ", " + closing);
}

std::string load_factor_text(const LoadCase& load_case) {
  constexpr double kAny = 1e5;  // beyond it the figure is rounding of an effort that is nearly 0
  if (load_case.strength > kAny) return "any";
  // Without an exponent.
  return formatted(load_case.strength < 99.5 ? "%.2g" : "%.0f", load_case.strength);
}

std::string weakness_text(const Robustness& robustness) {
  if (robustness.weakest_O.isZero(0.0)) return "";
  switch (robustness.weakest_end) {
    case Outcome::hand_blocked:
    case Outcome::approach_blocked:
      return "the hand runs into something";
    case Outcome::no_contact:
      return "the hand closes beside it";
    case Outcome::not_force_closure:
      return "the contacts do not hold it";
    case Outcome::no_seal:
      return "no cup seals";
    case Outcome::stable:
      return "the drives do not hold its weight";
    default:
      return std::string(name_of(robustness.weakest_end));
  }
}

std::string moved_text(const Trial& trial) {
  const auto millimetres = [](const char* what, double metres) {
    return metres < 5e-5 ? "" : formatted("%s by %.2g mm", what, 1e3 * metres);
  };
  const double turned = trial.turned * 180.0 / std::numbers::pi;
  std::string object;
  for (const std::string& part : {millimetres("pushed", trial.pushed.norm()),
                                  turned < 0.05 ? "" : formatted("turned by %.2g degrees", turned),
                                  millimetres("slid", trial.slid)}) {
    if (!part.empty()) object += (object.empty() ? "the object was " : ", ") + part;
  }
  const std::string hand = millimetres("the hand gave way", trial.overlap_shift.norm());
  return hand + (hand.empty() || object.empty() ? "" : "; ") + object;
}

std::string free_text(const Trial& free) {
  const bool is_in_hand =
      free.outcome == Outcome::stable || free.outcome == Outcome::not_force_closure;
  if (!is_in_hand) return std::string(name_of(free.outcome));
  const double epsilon = free.outcome == Outcome::stable ? free.epsilon.lower : 0.0;
  const double moved = free.X_OC ? free.X_OC->translation().norm() : 0.0;
  return formatted("epsilon %.4f, moved %.2g mm", epsilon, 1e3 * moved);
}

std::string collision_text(const CollisionNames& collision_of) {
  return collision_of.link.empty() ? "" : collision_of.link + " met " + collision_of.by;
}

std::string collision_text(const CompiledScene& scene, const Trial& trial) {
  const std::string words = collision_text(collision_of(scene, trial));
  if (words.empty() || !trial.overlap) return words;
  return words + formatted(", %.2g mm deep", 1e3 * *trial.overlap);
}

}  // namespace prehend
