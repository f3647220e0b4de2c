#include "benchmarks/suite/google_runs.h"

#include <benchmark/benchmark.h>
#include <map>

#include "benchmarks/report/names.h"

namespace prehend::bench {
namespace {

// Keeps what Google Benchmark would print.
class TimesOfRuns : public ::benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context& /*context*/) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration || run.error_occurred) continue;
      nanoseconds_[run.run_name.function_name].push_back(run.GetAdjustedCPUTime());
    }
  }
  const std::vector<double>& of(const std::string& name) { return nanoseconds_[name]; }

 private:
  std::map<std::string, std::vector<double>> nanoseconds_;
};

}  // namespace

void run_kernels(const std::vector<Kernel>& kernels, const Sizes& sizes, Record& record) {
  for (const Kernel& kernel : kernels) {
    ::benchmark::RegisterBenchmark(kernel.name.c_str(),
                                   [&kernel](::benchmark::State& state) {
                                     for (auto _ : state)
                                       ::benchmark::DoNotOptimize(kernel.call_all());
                                   })
        ->Repetitions(sizes.repetitions)
        ->MinTime(sizes.kernel_seconds)
        ->Unit(::benchmark::kNanosecond);
  }
  TimesOfRuns times;
  ::benchmark::RunSpecifiedBenchmarks(&times);
  ::benchmark::ClearRegisteredBenchmarks();
  for (const Kernel& kernel : kernels) {
    std::vector<double> nanoseconds = times.of(kernel.name);
    for (double& value : nanoseconds) value /= kernel.calls;
    record.add(kCall, kernel.name, "ns", nanoseconds);
  }
}

}  // namespace prehend::bench
