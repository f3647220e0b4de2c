// A report on executed grasps for people at a terminal and for programs.
#pragma once

#include <string>

#include "planner/show/validation/truth_report.h"

namespace prehend {

// Tables, in lines.
std::string truth_table(const TruthReport& report);

// All figures (docs/truth-file.md). The same report gives the same bytes.
std::string truth_json(const TruthReport& report);

// "500 executions of 10 objects in 3 sessions: 250 lifted, 250 failed"
std::string execution_words(const TruthReport& report);

// "95 % intervals from 2000 resamples of 10 objects"; says so where there are too few groups for
// the intervals to be trusted.
std::string interval_words(const TruthReport& report);

}  // namespace prehend
