// A report's data as its page reads it.
#pragma once

#include <string>

#include "planner/show/report/report.h"

namespace prehend {

// The report as JSON text. Lengths are in metres, rounded to a micrometre; poses are position and
// quaternion (x, y, z, w). The scripts of the page (page/) are its only reader.
std::string report_json(const Report& report);

}  // namespace prehend
