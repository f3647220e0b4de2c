// Single calls, measured by Google Benchmark (the only files of the suite to know it).
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "benchmarks/suite/effort.h"
#include "benchmarks/suite/record.h"

namespace prehend::bench {

// Calls to be measured together, so that each repetition has the same inputs. What they return
// keeps compilers from leaving them out.
struct Kernel {
  std::string name;
  int calls = 1;  // that `call_all` makes
  std::function<double()> call_all;
};

// Adds an entry for each kernel, in order: the processor time of one call [ns], which other
// programs that run disturb least. Its samples are the means of the repetitions.
void run_kernels(const std::vector<Kernel>& kernels, const Sizes& sizes, Record& record);

}  // namespace prehend::bench
