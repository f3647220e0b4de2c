#include "benchmarks/shake/shake_table.h"

#include <cstdio>

#include "benchmarks/shake/disagreements.h"
#include "benchmarks/support/resources.h"

namespace prehend::bench {
namespace {

double percent(int part, int whole) { return whole > 0 ? 100.0 * part / whole : 0.0; }

void print_opinion(const OpinionTally& tally, int grasps) {
  std::printf("   %5.1f %% %6.2f s %5.0f us", percent(tally.survived, grasps),
              tally.seconds / grasps, 1e6 * tally.seconds / tally.steps);
}

void print_failures(const char* who, const OpinionTally& tally) {
  bool any = false;
  for (const PhaseFailure failure : kAll<PhaseFailure>) {
    const int times = tally.failures[static_cast<std::size_t>(failure)];
    if (times == 0) continue;
    std::printf("%s %s %d", any ? "" : who, std::string(prehend::name_of(failure)).c_str(), times);
    any = true;
  }
}

void print_line(const std::string& name, const std::string& procedure, const ShakeTally& tally) {
  std::printf("%-28s %-18s %6d", name.c_str(), procedure.c_str(), tally.grasps);
  print_opinion(tally.ours, tally.grasps);
  print_opinion(tally.theirs, tally.grasps);
  std::printf("   %5.1f %%", percent(tally.agreed, tally.grasps));
  print_failures("   ours:", tally.ours);
  print_failures("   MuJoCo:", tally.theirs);
  std::printf("\n");
}

void add_to(OpinionTally& sum, const OpinionTally& part) {
  sum.survived += part.survived;
  sum.seconds += part.seconds;
  sum.steps += part.steps;
  for (std::size_t f = 0; f < sum.failures.size(); ++f) sum.failures[f] += part.failures[f];
}

void add_to(ShakeTally& sum, const ShakeTally& part) {
  sum.grasps += part.grasps;
  sum.agreed += part.agreed;
  add_to(sum.ours, part.ours);
  add_to(sum.theirs, part.theirs);
}

template <typename Run>
ShakeResult timed(OpinionTally& tally, const Run& run) {
  const double start = benchmark::processor_seconds();
  ShakeResult result = run();
  tally.add(result, benchmark::processor_seconds() - start);
  return result;
}

}  // namespace

void OpinionTally::add(const ShakeResult& result, double processor_seconds) {
  survived += result.survived() ? 1 : 0;
  seconds += processor_seconds;
  steps += result.steps;
  for (const ShakeTestResult& test : failed_tests(result)) {
    ++failures[static_cast<std::size_t>(test.phases.back().failure)];
  }
}

void ShakeTable::print_head() {
  std::printf("%-28s %-18s %6s   %-26s  %-26s   agree  tests that failed\n", "object:hand",
              "protocol", "grasps", "ours, s/grasp, a step", "MuJoCo, s/grasp, a step");
}

std::string ShakeTable::disagreement(const ShakeCase& shaken, const ShakenGrasp& grasp,
                                     const TestProcedure& procedure, const ShakeResult& ours,
                                     const ShakeResult& theirs) {
  std::string cause = "not searched";
  if (explain_) {
    cause = first_cause(counterfactuals(shaken, grasp, procedure, ours, theirs), ours.survived(),
                        theirs.survived())
                .value_or("unexplained");
  }
  ++causes_[cause];
  return "  " + shaken.name + " " + procedure.name + " " + std::to_string(grasp.rank) + ": " +
         cause + " (ours " + verdict_text(ours) + "; MuJoCo " + verdict_text(theirs) + ")";
}

void ShakeTable::add(const ShakeCase& shaken, const TestProcedure& procedure) {
  ShakeTally tally;
  std::vector<std::string> others;
  for (const ShakenGrasp& grasp : shaken.grasps) {
    const ShakeResult ours =
        timed(tally.ours, [&] { return in_prehend(shaken, grasp, procedure); });
    const ShakeResult theirs =
        timed(tally.theirs, [&] { return in_mujoco(shaken, grasp, procedure); });
    ++tally.grasps;
    if (ours.survived() == theirs.survived()) {
      ++tally.agreed;
    } else {
      others.push_back(disagreement(shaken, grasp, procedure, ours, theirs));
    }
  }
  print_line(shaken.name, procedure.name, tally);
  for (const std::string& line : others) std::printf("%s\n", line.c_str());
  std::fflush(stdout);
  add_to(sums_[shaken.scene.scene.hand.name + " " + procedure.name], tally);
}

void ShakeTable::print_sums() const {
  ShakeTally all;
  std::printf("\n");
  print_head();
  for (const auto& [key, tally] : sums_) {
    const std::size_t space = key.find(' ');
    print_line("all:" + key.substr(0, space), key.substr(space + 1), tally);
    add_to(all, tally);
  }
  if (all.grasps > 0) print_line("all", "all", all);
  std::printf("\ncauses of %d disagreements:\n", all.grasps - all.agreed);
  for (const auto& [cause, times] : causes_) std::printf("%6d  %s\n", times, cause.c_str());
}

}  // namespace prehend::bench
