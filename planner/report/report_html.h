// A report as one file for a browser, which fetches nothing when it opens.
#pragma once

#include <string>
#include <string_view>

#include "planner/report/report.h"

namespace prehend {

// Names are shown as text, whatever is in them. The same report is the same bytes.
std::string report_html(const Report& report);

// What stands before and after the report's data, which is JSON in a script element: the page
// (page/) with its style, its scripts and three.js. The build makes these two (page.cmake).
std::string_view page_before_data();
std::string_view page_after_data();

}  // namespace prehend
