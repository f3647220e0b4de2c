// A report as one HTML file that contains everything it needs and loads nothing from the network.
#pragma once

#include <string>
#include <string_view>

#include "planner/report/report.h"

namespace prehend {

// The HTML text. Names are escaped, so that markup in them is shown as text. The same report gives
// the same bytes.
std::string report_html(const Report& report);

// The parts of the HTML file before and after the report's data, which is JSON in a script element:
// the page (page/) with its style sheet, its scripts and three.js. Their definitions are generated
// by the build (page.cmake).
std::string_view page_before_data();
std::string_view page_after_data();

}  // namespace prehend
