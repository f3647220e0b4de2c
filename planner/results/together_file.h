// together.json: grasps of two hands that hold one object together (docs/how-to/arm.md).
#pragma once

#include <array>
#include <string>

#include "planner/plan/together/hold_together.h"
#include "planner/results/grasps_file.h"

namespace prehend {

// The whole file as text; the same for the same result. `records`: of the plans.
std::string together_json(const std::array<HandPlan, 2>& plans,
                          const std::array<RunRecord, 2>& records, const TogetherResult& result);

}  // namespace prehend
