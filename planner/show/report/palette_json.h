// The palette as pages read it.
#pragma once

#include <nlohmann/json.hpp>

namespace prehend {

// The colours that have a meaning (planner/show/palette.h): looks of bodies and marks as {"color":
// "#rrggbb", "opacity"}, "axes" and "outcomes" as colours alone.
nlohmann::ordered_json palette_json();

}  // namespace prehend
