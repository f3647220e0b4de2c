// What shaking showed of a grasp, as fields to be visited (json_fields.h). They are written only.
#pragma once

#include "sim/manipulation/shake_report.h"

namespace prehend {

void phase_fields(auto& fields, const PhaseReport& phase) {
  fields("kind", phase.kind);
  fields("seconds", phase.seconds);
  fields("moved", phase.moved);
  fields("turned", phase.turned);
  fields("sank", phase.sank);
  fields("rose", phase.rose);
  fields("touching", phase.touching);
}

void shake_test_fields(auto& fields, const ShakeTestReport& test) {
  fields("name", test.name);
  fields("outcome", test.outcome);
  const bool failed = test.outcome != ShakeOutcome::survived;
  fields("failed_at", failed ? std::optional(test.failed_at) : std::nullopt);
  fields.part("first_slip", test.first_slip, [](auto& inner, auto& slip) {
    inner("link", slip.link);
    inner("time", slip.time);
  });
  fields("largest_pull", test.largest_pull);
  fields.objects("phases", test.phases,
                 [](auto& inner, auto& phase) { phase_fields(inner, phase); });
}

// How much work a simulation was.
void effort_fields(auto& fields, const SimulationEffort& effort) {
  fields("steps", effort.steps);
  fields("shortened", effort.shortened);
  fields("not_converged", effort.not_converged);
  fields("crossings", effort.crossings);
  fields("violation", effort.violation);
  fields("simulated", effort.simulated);
  const bool ended_early = effort.last != StepOutcome::moved;
  fields("last_step", ended_early ? std::optional(effort.last) : std::nullopt);
}

void shake_fields(auto& fields, const ShakeReport& report) {
  fields("protocol", report.procedure);
  fields("survived", report.survived());
  fields("of", report.count());
  fields("holds", report.holds());
  fields("largest_pull", report.largest_pull());
  fields.objects("tests", report.tests,
                 [](auto& inner, auto& test) { shake_test_fields(inner, test); });
  fields.object("simulation", [&](auto& inner) { effort_fields(inner, report.effort); });
}

}  // namespace prehend
