// Results of the benchmarks, made up.
#pragma once

#include <string>
#include <vector>

#include "benchmarks/report/names.h"
#include "benchmarks/report/results.h"

namespace prehend::test {

inline bench::Entry bench_entry(const std::string& part, const std::string& group,
                                const std::string& series, const std::string& unit, double value,
                                std::optional<double> x = {}) {
  return {part, group, series, x, unit, bench::summarize({0.9 * value, value, 1.2 * value})};
}

// Some entries of each part: times of scaling with the exponents 1 and 2, curves with their knee at
// 200 trials.
inline bench::Results sample_results() {
  bench::Results results;
  results.effort = "full";
  results.machine = {"0.1.0", "GCC 12.2.0",          "Release", "A processor <& co>",
                     2,       "2026-01-31T23:59:59Z"};
  std::vector<bench::Entry>& entries = results.entries;
  entries.push_back(bench_entry(bench::kKernels, bench::kCall, "inside test", "ns", 250.0));
  entries.push_back(bench_entry(bench::kKernels, bench::kCall, "ε, 8 contacts", "ns", 2.5e5));
  const std::string mug = "barrett, mug";
  entries.push_back(bench_entry(bench::kTrials, bench::kTrialTime, mug, "ms", 4.0));
  entries.push_back(bench_entry(bench::kTrials, bench::kTriedPerSecond, mug, "1/s", 250.0));
  for (const char* stage : bench::kTrialStages) {
    entries.push_back(
        bench_entry(bench::kTrials, std::string(bench::kShareOf) + stage, mug, "%", 100.0 / 6.0));
  }
  entries.push_back(bench_entry(bench::kTrials, bench::kPath, "shelf", "ms", 120.0));
  const auto add_plan = [&](const std::string& group, const char* series, double value) {
    entries.push_back(bench_entry(bench::kPlans, group, series, "ms", value));
  };
  add_plan(bench::kRun, "mug", 900.0);
  add_plan(bench::kRun, "mug, draft", 400.0);
  add_plan(bench::kTimeOf + std::string("trials"), "mug", 500.0);
  add_plan(bench::kTimeOf + std::string("report"), "mug, draft", 150.0);
  entries.push_back(bench_entry(bench::kTrade, bench::kDefault, "standard", "trials", 800.0));
  for (const char* series : {"mug, draft", "mug, standard"}) {
    entries.push_back(bench_entry(bench::kTrade, bench::kTimePerTrial, series, "ms", 5.0));
    double epsilon = 0.05;
    for (const double trials : {50.0, 100.0, 200.0, 400.0, 800.0}) {
      entries.push_back(
          bench_entry(bench::kTrade, bench::kPlanTime, series, "s", 0.01 * trials, trials));
      entries.push_back(
          bench_entry(bench::kTrade, bench::kBestEpsilon, series, "1", epsilon, trials));
      epsilon += trials < 200.0 ? 0.05 : 0.001;
    }
  }
  for (const double x : {1000.0, 10000.0, 100000.0}) {
    entries.push_back(bench_entry(bench::kScaling, bench::kTriangles, "made ready", "ms", x, x));
    entries.push_back(
        bench_entry(bench::kScaling, bench::kTriangles, "squared", "ms", 1e-3 * x * x, x));
    entries.push_back(
        bench_entry(bench::kScaling, bench::kTriangles, "memory", "MB", 20.0 + 1e-3 * x, x));
  }
  return results;
}

}  // namespace prehend::test
