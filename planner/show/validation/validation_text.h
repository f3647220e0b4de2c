// A report on executed grasps for people at a terminal and for programs.
#pragma once

#include <string>

#include "planner/show/validation/validation_report.h"

namespace prehend {

// Tables, in lines.
std::string validation_table(const ValidationReport& report);

// All figures (docs/reference/truth-file.md). The same report gives the same bytes.
std::string validation_json(const ValidationReport& report);

// "500 executions of 10 objects in 3 sessions: 250 lifted, 250 failed"
std::string execution_text(const ValidationReport& report);

// "95 % intervals from 2000 resamples of 10 objects"; says so where there are too few groups for
// the intervals to be trusted.
std::string interval_text(const ValidationReport& report);

}  // namespace prehend
