// The parts of the suite. Each appends what it measured to the entries.
#pragma once

#include <string>
#include <vector>

#include "benchmarks/report/results.h"
#include "benchmarks/suite/effort.h"

namespace prehend::bench {

// Single calls, by Google Benchmark.
void measure_kernels(const Sizes& sizes, std::vector<Entry>& entries);

// Whole trials by hand and object, with the share of each stage; and paths, in scenes with an arm.
void measure_trials(const Sizes& sizes, std::vector<Entry>& entries);
void measure_paths(const Sizes& sizes, std::vector<Entry>& entries);

// Whole runs of `prehend plan`, with all their stages, beside those of trials: what users wait for.
void measure_plans(const Sizes& sizes, std::vector<Entry>& entries);

// Time against accuracy.
void measure_trade(const Sizes& sizes, std::vector<Entry>& entries);

// Times over sizes, and memory. `program` is this program, which is started again to measure
// memory; `cores`: processors of this machine.
void measure_scaling(const Sizes& sizes, const std::string& program, int cores,
                     std::vector<Entry>& entries);

}  // namespace prehend::bench
