// The machine and the build that measure.
#pragma once

#include <string>

#include "benchmarks/report/results.h"

namespace prehend::bench {

// `prehend` and `build` as the build system knows them; the date is now.
Machine this_machine(const std::string& prehend, const std::string& build);

}  // namespace prehend::bench
