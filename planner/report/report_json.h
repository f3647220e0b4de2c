// A report's data as its page reads it.
#pragma once

#include <string>

#include "planner/report/report.h"

namespace prehend {

// Lengths in metres, rounded to a micrometre; poses as position and quaternion (x, y, z, w).
std::string report_json(const Report& report);

}  // namespace prehend
