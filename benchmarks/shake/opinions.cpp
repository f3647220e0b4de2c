#include "benchmarks/shake/opinions.h"

#include "benchmarks/shake/mujoco_shake.h"
#include "planner/exports/export_files.h"
#include "sim/manipulation/shake.h"

namespace prehend::bench {
namespace {

ShakeResult in_mujoco(const ShakeCase& shaken, const ShakenGrasp& grasp, const Protocol& protocol) {
  MjcfOptions options;
  options.obstacles = protocol.on_support;
  const ExportGrasp exported = export_of(shaken.scene, grasp.grasp, grasp.rank);
  return shake_in_mujoco(mjcf_text(shaken.scene, shaken.shapes, exported, options), protocol,
                         subject_of(shaken.scene));
}

// Failures are named in the order of ShakeOutcome.
PhaseFailure failure_of(ShakeOutcome outcome) {
  return kPhaseFailures[static_cast<std::size_t>(outcome)];
}

ShakeTestResult result_of(const ShakeTestReport& test) {
  ShakeTestResult result{.name = test.name, .phases = {}};
  for (const PhaseReport& phase : test.phases) {
    PhaseMeasure measure;
    measure.moved = phase.moved;
    measure.turned = phase.turned;
    measure.dropped = phase.sank;
    measure.rise = phase.rose;
    measure.in_contact = phase.touching > 0;
    result.phases.push_back({phase.kind, measure, PhaseFailure::none});
  }
  result.phases.back().failure = failure_of(test.outcome);
  return result;
}

ShakeResult in_prehend(const ShakeCase& shaken, const ShakenGrasp& grasp,
                       const Protocol& protocol) {
  const ShakeReport report =
      shake_grasp(shaken.scene, hand_model(shaken.scene), posture_of(grasp.grasp.trial), protocol);
  ShakeResult result;
  result.prepare.name = "prepare";
  for (const ShakeTestReport& test : report.tests) {
    if (test.name == "prepare") {
      result.prepare = result_of(test);
    } else {
      result.tests.push_back(result_of(test));
    }
  }
  result.steps = report.effort.steps;
  return result;
}

}  // namespace

std::vector<Opinion> opinions() { return {{"prehend", in_prehend}, {"MuJoCo", in_mujoco}}; }

}  // namespace prehend::bench
