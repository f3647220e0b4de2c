#include "planner/results/json_shake.h"

#include <nlohmann/json.hpp>

namespace prehend {
namespace {

using Json = nlohmann::ordered_json;

Json phase_to_json(const PhaseReport& phase) {
  return {{"kind", phase_kind_name(phase.kind)},
          {"seconds", phase.seconds},
          {"moved", phase.moved},
          {"turned", phase.turned},
          {"sank", phase.sank},
          {"rose", phase.rose},
          {"touching", phase.touching}};
}

}  // namespace

Json shake_test_to_json(const ShakeTestReport& test) {
  Json json{{"name", test.name}, {"outcome", shake_outcome_name(test.outcome)}};
  if (test.outcome != ShakeOutcome::survived) json["failed_at"] = test.failed_at;
  if (test.first_slip) {
    json["first_slip"] = {{"link", test.first_slip->link}, {"time", test.first_slip->time}};
  }
  if (test.largest_pull) json["largest_pull"] = *test.largest_pull;
  json["phases"] = Json::array();
  for (const PhaseReport& phase : test.phases) json["phases"].push_back(phase_to_json(phase));
  return json;
}

Json effort_to_json(const SimulationEffort& effort) {
  Json json{{"steps", effort.steps},
            {"shortened", effort.shortened},
            {"not_converged", effort.not_converged},
            {"crossings", effort.crossings},
            {"violation", effort.violation},
            {"simulated", effort.simulated}};
  if (effort.last != StepOutcome::moved) json["last_step"] = step_outcome_name(effort.last);
  return json;
}

Json shake_to_json(const ShakeReport& report) {
  Json json{{"protocol", report.procedure},
            {"survived", report.survived()},
            {"of", report.count()},
            {"holds", report.holds()}};
  if (const std::optional<double> pull = report.largest_pull()) json["largest_pull"] = *pull;
  json["tests"] = Json::array();
  for (const ShakeTestReport& test : report.tests)
    json["tests"].push_back(shake_test_to_json(test));
  json["simulation"] = effort_to_json(report.effort);
  return json;
}

}  // namespace prehend
