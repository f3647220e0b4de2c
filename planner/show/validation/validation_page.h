// A report on executed grasps as one HTML file that contains all it needs.
#pragma once

#include <string>

#include "planner/show/validation/validation_report.h"

namespace prehend {

// Tables, the curves of the rankings and of the calibration as SVG, light or dark as the reader's
// system is. No scripts, nothing from the network. Text from files is escaped. The same report
// gives the same bytes.
std::string validation_page(const ValidationReport& report);

}  // namespace prehend
