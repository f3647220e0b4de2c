// The options of a plan as its stages take them.
#pragma once

#include "planner/plan/plan_options.h"

namespace prehend {

// The options with every seed in them derived from the one of the plan, and without the depth of
// overlaps: a search leaves candidates out that are blocked, however deep. Among obstacles most of
// them are, and to measure all took a fifth of the time.
PlanOptions search_settings(PlanOptions options);

}  // namespace prehend
