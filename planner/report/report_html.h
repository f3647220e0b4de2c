// A report as one file for a browser, which fetches nothing when it opens.
#pragma once

#include <string>

#include "planner/report/report.h"

namespace prehend {

// Names are shown as text, whatever is in them. The same report is the same bytes.
std::string report_html(const Report& report);

}  // namespace prehend
